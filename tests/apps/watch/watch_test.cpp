#include "apps/watch/watch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/config/flight_request.h"
#include "apps/watch/grabber_feed.h"
#include "apps/watch/watch_table.h"
#include "tests/support/scripted_source.h"
#include "vehicle/grabber/steady_source.h"

namespace lineservo::apps {
namespace {

using ::testing::HasSubstr;

/// A yellow stripe straight ahead, its middle this far to the right of the image's.
cv::Mat stripe(int right_px, int width_px = 640) {
  cv::Mat image(480, width_px, CV_8UC3, cv::Scalar(110, 110, 110));
  image(cv::Rect(width_px / 2 - 40 + right_px, 0, 80, 480)).setTo(cv::Scalar(0, 200, 220));
  return image;
}

/// A source double in the place of a device, of files or of a stream.
class Watching : public ::testing::Test {
 protected:
  WatchEnd watch_images(std::vector<cv::Mat> images, const std::string& breaks_off = "",
                        const WatchOptions& options = {}, Pace pace = Pace::files) {
    auto source = std::make_unique<vehicle::SteadySource>(
        std::make_unique<support::ScriptedSource>(std::move(images), breaks_off), "camera");
    GrabberFeed feed(std::move(source), {}, Estimates(0.5), pace);
    WatchChains chains(feed.camera(), settings_, {"ibvs", "lfpf"});
    return watch(feed, chains, options, [this](const Watched& watched) {
      rows_.push_back(watch_row(watched));
      outputs_.push_back(watched.outputs);
      delays_ms_.push_back(watched.delay_ms);
    });
  }
  const servo::VelocityCommand& ibvs(std::size_t tick) const {
    return std::get<servo::VelocityCommand>(outputs_.at(tick).at(0).command);
  }

  Settings settings_;
  std::vector<std::string> rows_;
  std::vector<std::vector<ChainOutput>> outputs_;
  std::vector<std::optional<double>> delays_ms_;
};

// To the right of the middle the line is to the vehicle's right: there it goes, by the first frame at once.
TEST_F(Watching, EachControllerSaysItsCommandForEachFrame) {
  const WatchEnd end = watch_images({stripe(60), stripe(60)});
  EXPECT_EQ(end.frames, 2);
  EXPECT_EQ(end.broke_off, "");
  EXPECT_FALSE(end.interrupted);
  ASSERT_EQ(rows_.size(), 2u);
  const features::LineFeature* line = outputs_[0][0].features.line();
  ASSERT_NE(line, nullptr);
  EXPECT_NEAR(line->rho, 60.0 / 320.0, 0.003);
  EXPECT_NEAR(line->theta_rad, 0.0, 0.003);
  EXPECT_LT(ibvs(0).left_m_s, -0.02);
  EXPECT_GT(ibvs(0).forward_m_s, 0.1);
  EXPECT_GT(std::get<servo::AttitudeCommand>(outputs_[0][1].command).roll_rad, 0.0);
  EXPECT_FALSE(delays_ms_[0]);
}

TEST_F(Watching, WithoutALineItSaysSo) {
  watch_images({cv::Mat(480, 640, CV_8UC3, cv::Scalar(110, 110, 110))});
  EXPECT_EQ(outputs_.at(0).at(0).features.line(), nullptr);
  EXPECT_THAT(rows_.at(0), HasSubstr("0.0000,0,0,nan,nan,nan,nan,nan,1,1,1,0.500000,"));
}

TEST_F(Watching, AStreamThatStopsLeavesWhatCameBefore) {
  const WatchEnd end = watch_images({stripe(0), stripe(0)}, "camera: the stream stops after 2 frames");
  EXPECT_EQ(end.frames, 2);
  EXPECT_EQ(end.broke_off, "camera: the stream stops after 2 frames");
  EXPECT_EQ(rows_.size(), 2u);
}

TEST_F(Watching, AChangeOfSizeLeavesWhatCameBefore) {
  const WatchEnd end = watch_images({stripe(0), stripe(0, 320)});
  EXPECT_EQ(end.frames, 1);
  EXPECT_THAT(end.broke_off, HasSubstr("frame 1 is 320×480 px, the source 640×480"));
  EXPECT_EQ(rows_.size(), 1u);
}

TEST_F(Watching, EndsAfterSoManyFramesOrWhenItIsToldTo) {
  WatchOptions two;
  two.frames = 2;
  EXPECT_EQ(watch_images({stripe(0), stripe(0), stripe(0)}, "", two).frames, 2);
  WatchOptions until_three;
  until_three.goes_on = [this] { return rows_.size() < 3; };
  const WatchEnd end = watch_images({stripe(0), stripe(0), stripe(0)}, "", until_three);
  EXPECT_EQ(end.frames, 1);
  EXPECT_TRUE(end.interrupted);
}

TEST_F(Watching, OfACameraTheDelayIsTold) {
  watch_images({stripe(0)}, "", {}, Pace::live);
  ASSERT_TRUE(delays_ms_.at(0));
  EXPECT_GT(*delays_ms_[0], 0.0);
}

TEST(WatchTable, HasACellForEachColumn) {
  const std::string header = watch_header({"ibvs", "lfpf"});
  const WatchTick tick{};
  const std::vector<ChainOutput> outputs(2);
  const std::string row = watch_row({tick, outputs, 0.1, std::nullopt});
  EXPECT_EQ(std::count(header.begin(), header.end(), ','), std::count(row.begin(), row.end(), ','));
  EXPECT_THAT(header, HasSubstr(",delay_ms,ibvs.forward_m_s,"));
  EXPECT_THAT(header, HasSubstr(",lfpf.height_m\n"));
}

}  // namespace
}  // namespace lineservo::apps
