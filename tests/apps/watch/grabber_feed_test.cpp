#include "apps/watch/grabber_feed.h"

#include <gtest/gtest.h>

#include <chrono>

#include "tests/support/scripted_source.h"
#include "vehicle/time.h"

namespace lineservo::apps {
namespace {

using vehicle::from_seconds;

/// In the place of a camera: three frames, stamped a little ago on the monotonic clock.
class CameraDouble final : public vehicle::FrameSource {
 public:
  static constexpr vehicle::Time kAge = std::chrono::milliseconds(40);

  vehicle::SourceFormat format() const override { return {64, 48, 0.0}; }
  std::optional<vehicle::SourceFrame> next() override {
    if (index_ == 3) return std::nullopt;
    const vehicle::Time now = std::chrono::steady_clock::now().time_since_epoch();
    return vehicle::SourceFrame{index_++, now - kAge, cv::Mat(48, 64, CV_8UC3, cv::Scalar::all(7))};
  }

 private:
  std::int64_t index_ = 0;
};

features::CameraParameters camera() {
  features::CameraParameters camera;
  camera.width_px = 64;
  camera.height_px = 48;
  return camera;
}

TEST(GrabberFeed, OfFilesATickIsAtItsFramesStamp) {
  const cv::Mat image(48, 64, CV_8UC3, cv::Scalar::all(7));
  GrabberFeed feed(std::make_unique<support::ScriptedSource>(std::vector{image, image}), camera(),
                   Estimates(0.8), Pace::files);
  EXPECT_FALSE(feed.is_live());
  EXPECT_EQ(feed.next()->input.now, vehicle::Time{0});
  const auto second = feed.next();
  EXPECT_EQ(second->frame, 1);
  EXPECT_EQ(second->input.now, from_seconds(0.1));
  EXPECT_EQ(second->input.captured, from_seconds(0.1));
  EXPECT_EQ(second->input.exposed, from_seconds(0.1));
  EXPECT_EQ(second->input.estimate.height_m, 0.8);
  EXPECT_EQ(second->input.estimate.capture_height_m, 0.8);
  EXPECT_FALSE(second->exposed_at);
  EXPECT_FALSE(feed.next());
}

TEST(GrabberFeed, OfACameraATickComesAfterTheExposure) {
  GrabberFeed feed(std::make_unique<CameraDouble>(), camera(), Estimates(0.5), Pace::live);
  EXPECT_TRUE(feed.is_live());
  vehicle::Time last{-1};
  while (const auto tick = feed.next()) {
    EXPECT_GT(tick->input.exposed, last);
    EXPECT_GE(tick->input.now - tick->input.exposed, CameraDouble::kAge);
    EXPECT_TRUE(tick->exposed_at);
    last = tick->input.exposed;
  }
}

TEST(GrabberFeed, TakesTheEstimatesAtEachInstant) {
  const cv::Mat image(48, 64, CV_8UC3, cv::Scalar::all(7));
  EstimateAt first, last;
  last.t = from_seconds(0.1);
  last.height_m = 1.0;
  last.roll_rad = 0.1;
  last.v_H_m_s = {0.1, 0.2, 0.3};
  last.odometry = {{1.0, 2.0}, 0.5};
  GrabberFeed feed(std::make_unique<support::ScriptedSource>(std::vector{image, image}), camera(),
                   Estimates({first, last}, "e"), Pace::files);
  EXPECT_EQ(feed.next()->input.estimate.height_m, 0.5);
  const TickInput input = feed.next()->input;
  EXPECT_EQ(input.estimate.height_m, 1.0);
  EXPECT_EQ(input.estimate.capture_height_m, 1.0);
  EXPECT_EQ(input.roll_rad, 0.1);
  EXPECT_EQ(input.estimate.v_H_m_s, last.v_H_m_s);
  EXPECT_EQ(input.estimate.odometry_now.translation_m, last.odometry.translation_m);
  EXPECT_EQ(input.estimate.odometry_at_capture.yaw_rad, 0.5);
}

}  // namespace
}  // namespace lineservo::apps
