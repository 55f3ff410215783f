#include "apps/report/film_strip.h"

#include <gtest/gtest.h>
#include <openssl/evp.h>

#include <cmath>
#include <opencv2/core.hpp>
#include <set>

#include "apps/image/image_file.h"
#include "tests/apps/flight/test_flight.h"
#include "tests/apps/test_files.h"

namespace lineservo::apps {
namespace {

using std::chrono::milliseconds;

/// A grey frame that tells its number.
cv::Mat frame(int number, cv::Size size = {640, 480}) {
  return {size, CV_8UC3, cv::Scalar::all(7 * number % 250)};
}

FilmStrip strip_of(int frames, milliseconds period, cv::Size size = {40, 30}) {
  FilmStrip film;
  for (int k = 0; k < frames; ++k) film.add(k * period, frame(k, size));
  return film;
}

/// What a browser makes of it.
cv::Mat shown(const Thumbnail& thumbnail) {
  const std::string head = "data:image/jpeg;base64,";
  EXPECT_TRUE(thumbnail.data_uri.starts_with(head));
  const std::string text = thumbnail.data_uri.substr(head.size());
  std::string bytes(text.size() / 4 * 3, '\0');
  EXPECT_EQ(
      EVP_DecodeBlock(reinterpret_cast<unsigned char*>(bytes.data()),
                      reinterpret_cast<const unsigned char*>(text.data()), static_cast<int>(text.size())),
      static_cast<int>(bytes.size()));
  const testing::TempFolder temp;
  return read_image(temp.write("thumbnail.jpg", bytes));
}

TEST(FilmStrip, KeepsAtMostSoManyEvenlyHoweverLongTheFlight) {
  for (const int frames : {10, 1496, 1497, 2000, 9999}) {
    const auto list = strip_of(frames, milliseconds(100)).thumbnails();
    const double end_s = 0.1 * (frames - 1);
    EXPECT_LE(list.size(), FilmStrip::kMost) << frames;
    EXPECT_GE(list.size(),
              std::min<std::size_t>(FilmStrip::kMost / 2, static_cast<std::size_t>(end_s / 0.6)));
    EXPECT_EQ(list.front().t_s, 0.0);
    const double step_s = list[1].t_s - list[0].t_s;
    for (std::size_t k = 1; k < list.size(); ++k) EXPECT_NEAR(list[k].t_s - list[k - 1].t_s, step_s, 1e-9);
    EXPECT_LE(end_s - list.back().t_s, step_s) << frames;
  }
}

TEST(FilmStrip, APictureIsTheFrameOfItsTime) {
  for (const Thumbnail& thumbnail : strip_of(2000, milliseconds(33)).thumbnails()) {
    const int number = static_cast<int>(std::lround(thumbnail.t_s / 0.033));
    EXPECT_NEAR(cv::mean(shown(thumbnail))[1], 7 * number % 250, 2.0) << thumbnail.t_s;
  }
}

TEST(FilmStrip, MakesFramesSmallAndKeepsTheirShape) {
  for (const auto& [from, to] : {std::pair{cv::Size(640, 480), cv::Size(200, 150)},
                                 {{160, 120}, {160, 120}},
                                 {{1920, 1080}, {200, 113}},
                                 {{400, 1}, {200, 1}},
                                 {{1, 1}, {1, 1}}}) {
    FilmStrip film;
    film.add(milliseconds(0), frame(7, from));
    EXPECT_EQ(shown(film.thumbnails().at(0)).size(), to);
  }
}

TEST(FilmStrip, KeepsUpAndDownAndColours) {
  FilmStrip film;
  cv::Mat bgr(480, 640, CV_8UC3, cv::Scalar(0, 0, 255));
  bgr.rowRange(240, 480).setTo(cv::Scalar(255, 0, 0));
  film.add(milliseconds(0), bgr);
  const cv::Mat small = shown(film.thumbnails().at(0));
  EXPECT_LT(cv::norm(small.at<cv::Vec3b>(10, 100), cv::Vec3b(0, 0, 255), cv::NORM_INF), 12.0);
  EXPECT_LT(cv::norm(small.at<cv::Vec3b>(140, 100), cv::Vec3b(255, 0, 0), cv::NORM_INF), 12.0);
}

TEST(FilmStrip, OfAFlightHasTicksWithAFrameAlone) {
  FlightRequest request = testing::request_for("a13", "paper");
  apply_override(request, "faults.camera_silent.start_s=6");
  apply_override(request, "faults.camera_silent.duration_s=1");
  FilmStrip film;
  const FlownMission flown = fly_mission(
      prepare(request), [](const FlightProgress& progress) { return progress.time_s < 10; },
      [&film](const FlightTick& tick) { film.add(tick); });
  std::set<double> seen_s;
  for (const TickRecord& tick : flown.record.ticks)
    if (tick.has_frame) seen_s.insert(servo::seconds(tick.t));
  const auto list = film.thumbnails();
  EXPECT_GE(list.size(), 15u);
  for (const Thumbnail& thumbnail : list) EXPECT_TRUE(seen_s.contains(thumbnail.t_s)) << thumbnail.t_s;
}

TEST(FilmStrip, OfAFlightThatSawNothingIsEmpty) {
  EXPECT_TRUE(FilmStrip().thumbnails().empty());
}

}  // namespace
}  // namespace lineservo::apps
