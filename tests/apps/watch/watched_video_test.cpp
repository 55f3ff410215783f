// The frames of a flight as a video file: watched, they show the features that the flight had.
#include <gtest/gtest.h>

#include <opencv2/videoio.hpp>

#include "apps/grabber/load_grabbers.h"
#include "apps/recording/digest.h"
#include "apps/watch/grabber_feed.h"
#include "apps/watch/watch.h"
#include "tests/apps/recording/recorded_flight.h"

namespace lineservo::apps {
namespace {

/// FFV1: without loss.
void write_video(const std::string& file, const Recording& recording) {
  cv::VideoWriter writer(file, cv::CAP_FFMPEG, cv::VideoWriter::fourcc('F', 'F', 'V', '1'), 10.0,
                         {recording.camera.width_px, recording.camera.height_px});
  ASSERT_TRUE(writer.isOpened());
  for (const RecordedTick& tick : recording.ticks) writer.write(*read_frame(recording, tick));
}

// A video does not tell how the vehicle tilts: the flight looks without correcting it.
TEST(WatchedVideo, ShowsTheFeaturesThatTheFlightHad) {
  const FlightRequest request = testing::short_request({"features.tilt_correction=false"});
  const testing::TempFolder temp;
  testing::record_flight(temp.path() / "flight", request);
  const Recording recording = read_recording(temp.path() / "flight");
  const std::string video = (temp.path() / "flight.avi").string();
  write_video(video, recording);

  GrabberFeed feed(load_source(video, {}), recording.camera, Estimates(request.settings.height_m),
                   Pace::files);
  WatchChains chains(feed.camera(), request.settings, {request.controller});
  std::size_t same = 0;
  const WatchEnd end = watch(feed, chains, {}, [&](const Watched& watched) {
    const RecordedTick& flown = recording.ticks.at(static_cast<std::size_t>(watched.tick.frame));
    same += digest(watched.outputs.front().features) == flown.outputs.front().features_sha256 ? 1 : 0;
  });
  EXPECT_EQ(end.broke_off, "");
  EXPECT_GT(recording.ticks.size(), 100u);
  EXPECT_EQ(same, recording.ticks.size());
}

}  // namespace
}  // namespace lineservo::apps
