#include "vehicle/floor/synthetic_camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>
#include <set>
#include <stdexcept>
#include <vector>

#include "features/geometry/angles.h"
#include "tests/vehicle/floor/render_oracle.h"
#include "tests/vehicle/floor/test_layouts.h"

namespace lineservo::vehicle {
namespace {

using namespace std::chrono_literals;

Eigen::Isometry3d body_at(double x_m, double y_m, double height_m) {
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  X_WB.translation() << x_m, y_m, height_m;
  return X_WB;
}

SyntheticCameraOptions small_camera(double frame_rate_hz, double latency_s, double noise_sigma) {
  SyntheticCameraOptions options;
  options.camera = {64, 48, 32.0, 32.0, 31.5, 23.5, {}};
  options.frame_rate_hz = frame_rate_hz;
  options.link.latency_s = latency_s;
  options.noise_sigma = noise_sigma;
  return options;
}

SyntheticCamera camera(double frame_rate_hz, double latency_s, double noise_sigma = 0.0,
                       std::uint64_t seed = 1) {
  return SyntheticCamera(test::warehouse(), small_camera(frame_rate_hz, latency_s, noise_sigma), seed);
}

TEST(SyntheticCamera, ExposesAtMultiplesOfThePeriodWithoutDrift) {
  SyntheticCamera cam = camera(30.0, 0.0);
  const Eigen::Isometry3d X_WB = body_at(4.2, 0.6, 0.5);
  for (std::int64_t k = 0; k < 3000; ++k) {
    const Time expected((k * 1'000'000'000 + 15) / 30);
    ASSERT_EQ(cam.next_exposure(), expected);
    ASSERT_FALSE(cam.due(expected - 1ns));
    ASSERT_TRUE(cam.due(expected));
    cam.capture(expected, X_WB);
    ASSERT_EQ(cam.deliver(expected)->index, k);
  }
}

TEST(SyntheticCamera, DeliversALatencyAfterTheExposureInOrder) {
  SyntheticCamera cam = camera(100.0, 0.025);
  const Eigen::Isometry3d X_WB = body_at(4.2, 0.6, 0.5);
  EXPECT_FALSE(cam.deliver(1s).has_value());
  EXPECT_EQ(cam.next_delivery(), Time::max());
  for (const Time now : {0ms, 10ms, 20ms}) cam.capture(now, X_WB);
  EXPECT_EQ(cam.next_delivery(), Time(25ms));
  EXPECT_FALSE(cam.deliver(25ms - 1ns).has_value());
  EXPECT_EQ(cam.deliver(25ms)->stamp, Time(0));
  EXPECT_FALSE(cam.deliver(25ms).has_value());
  EXPECT_EQ(cam.deliver(50ms)->stamp, Time(10ms));
  EXPECT_EQ(cam.deliver(50ms)->index, 2);
}

TEST(SyntheticCamera, LostFramesAreNotDeliveredAndTheOthersKeepTheirNumbers) {
  SyntheticCameraOptions options = small_camera(100.0, 0.025, 0.0);
  options.link.jitter_s = 0.02;
  options.link.drop_share = 0.3;
  SyntheticCamera cam(test::warehouse(), options, 4);
  const FrameLink link(options.link, 4);
  std::vector<std::int64_t> expected, delivered;
  for (int k = 0; k < 200; ++k) {
    cam.capture(k * 10ms, body_at(4.2, 0.6, 0.5));
    if (!link.loses(k)) expected.push_back(k);
    while (const std::optional<Frame> frame = cam.deliver((k + 1) * 10ms - 1ns)) {
      EXPECT_EQ(frame->stamp, frame->index * 10ms);
      delivered.push_back(frame->index);
    }
  }
  while (const std::optional<Frame> frame = cam.deliver(3s)) delivered.push_back(frame->index);
  EXPECT_EQ(delivered, expected);
  EXPECT_LT(expected.size(), 180U);
}

TEST(SyntheticCamera, SkipsExposuresThatWereMissed) {
  SyntheticCamera cam = camera(100.0, 0.0);
  cam.capture(35ms, body_at(4.2, 0.6, 0.5));
  const std::optional<Frame> frame = cam.deliver(35ms);
  EXPECT_EQ(frame->index, 3);
  EXPECT_EQ(frame->stamp, Time(35ms));
  EXPECT_EQ(cam.next_exposure(), Time(40ms));
}

// The middle row is exposed from 4 ms before the stamp to 4 ms after it: over the true way, not after it.
TEST(SyntheticCamera, AnOpenShutterIsFollowedToItsEndAndStampedInItsMiddle) {
  SyntheticCameraOptions options = small_camera(50.0, 0.002, 0.0);
  options.shutter.exposure_s = 0.008;
  options.shutter.readout_s = 0.004;
  SyntheticCamera cam(test::warehouse(), options, 1);
  ASSERT_TRUE(cam.follows_motion());
  const auto pose_at = [](Time t) { return body_at(4.2 + 2.0 * seconds(t), 0.6, 0.5); };
  for (Time now = 0ms; now < 26ms; now += 1ms) {
    cam.move(now, pose_at(now));
    if (cam.due(now)) cam.capture(now, pose_at(now));
    EXPECT_EQ(cam.has_exposed(now), now == Time(6ms));
    if (cam.has_exposed(now)) cam.develop();
    if (now == 6ms) {
      EXPECT_EQ(cam.deliver(now)->stamp, Time(0));
    }
  }
  cam.move(26ms, pose_at(26ms));
  EXPECT_TRUE(cam.has_exposed(26ms));
  const std::optional<Frame> frame = cam.deliver(26ms);
  EXPECT_EQ(frame->stamp, Time(20ms));
  FloorRenderer renderer(test::warehouse(), features::CameraModel(options.camera));
  ShutterWarp warp(renderer.grid(), options.shutter);
  cv::Mat expected;
  renderer.render(
      [&](double t_s) {
        Eigen::Isometry3d X = pose_at(20ms + from_seconds(t_s));
        X.linear() = features::down_camera_R_BC();
        return X;
      },
      warp, expected);
  EXPECT_LE(cv::norm(frame->bgr, expected, cv::NORM_INF), 1.0);
}

TEST(SyntheticCamera, TheTopOfTheImageIsForward) {
  SyntheticCamera cam = camera(10.0, 0.0);
  // 0.5 m short of column 1 facing it: the column lies ahead, at the top; row 0 is in the middle.
  cam.capture(0ms, body_at(4.2 - 0.5, 0.6, 0.7));
  const cv::Mat bgr = cam.deliver(0ms)->bgr;
  EXPECT_EQ(bgr.at<cv::Vec3b>(47, 2), cv::Vec3b(120, 120, 120));
  EXPECT_EQ(bgr.at<cv::Vec3b>(47, 61), cv::Vec3b(120, 120, 120));
  EXPECT_EQ(bgr.at<cv::Vec3b>(1, 2), cv::Vec3b(0, 200, 230));     // left of forward is +y: painted
  EXPECT_EQ(bgr.at<cv::Vec3b>(1, 61), cv::Vec3b(120, 120, 120));  // column 1 starts on row 0
  EXPECT_EQ(bgr.at<cv::Vec3b>(24, 32), cv::Vec3b(0, 200, 230));
}

TEST(SyntheticCamera, TheSameSeedGivesTheSameFrames) {
  SyntheticCamera one = camera(10.0, 0.0, 0.02, 1), same = camera(10.0, 0.0, 0.02, 1),
                  other = camera(10.0, 0.0, 0.02, 2);
  for (SyntheticCamera* cam : {&one, &same, &other}) cam->capture(0ms, body_at(4.2, 0.6, 0.5));
  const cv::Mat frame = one.deliver(0ms)->bgr;
  EXPECT_EQ(cv::norm(frame, same.deliver(0ms)->bgr, cv::NORM_INF), 0.0);
  EXPECT_GT(cv::norm(frame, other.deliver(0ms)->bgr, cv::NORM_INF), 0.0);
}

TEST(SyntheticCamera, ReusesBuffersButNeverOneThatIsHeld) {
  SyntheticCamera cam = camera(100.0, 0.0);
  cam.capture(0ms, body_at(4.2, 0.6, 0.5));
  const Frame held = *cam.deliver(0ms);
  const cv::Mat copy = held.bgr.clone();
  std::set<const std::uint8_t*> buffers;
  for (int k = 1; k < 50; ++k) {
    cam.capture(k * 10ms, body_at(6.0, 1.5, 0.5));
    buffers.insert(cam.deliver(k * 10ms)->bgr.data);
  }
  EXPECT_EQ(buffers.size(), 1U);
  EXPECT_EQ(buffers.count(held.bgr.data), 0U);
  EXPECT_EQ(cv::norm(held.bgr, copy, cv::NORM_INF), 0.0);
}

TEST(SyntheticCamera, RefusesOptionsOutOfBounds) {
  EXPECT_THROW(camera(0.0, 0.0), std::invalid_argument);
  EXPECT_THROW(camera(1001.0, 0.0), std::invalid_argument);
  EXPECT_THROW(camera(30.0, -0.001), std::invalid_argument);
  EXPECT_THROW(camera(30.0, 1.001), std::invalid_argument);
  EXPECT_THROW(camera(30.0, 0.0, 0.2), std::invalid_argument);
  EXPECT_NO_THROW(camera(1000.0, 1.0, 0.1));
}

// Turned by a about x_B, the camera sees what lies at the angle b to the right of the vehicle's foot at
// f tan(a + b).
TEST(SyntheticCamera, AMountThatIsOffShiftsTheImage) {
  const double tilt_rad = features::radians(1.0);
  SyntheticCameraOptions options = small_camera(10.0, 0.0, 0.0);
  options.camera = {640, 480, 320.0, 320.0, 319.5, 239.5, {}};
  options.mount_tilt_rad.x() = tilt_rad;
  SyntheticCamera off(test::single_line({-5, 0}, {5, 0}, 0.1), options, 1);
  off.capture(0ms, body_at(0.0, 0.0, 0.5));
  const cv::Mat bgr = off.deliver(0ms)->bgr;
  double sum = 0.0, moment = 0.0;
  for (int u = 0; u < bgr.cols; ++u) {
    const double paint = 1.0 - bgr.at<cv::Vec3b>(240, u)[0] / 120.0;
    sum += paint;
    moment += paint * (u - 319.5);
  }
  const double edge_rad = std::atan(0.05 / 0.5);
  const double right_px = 320.0 * std::tan(tilt_rad + edge_rad),
               left_px = 320.0 * std::tan(tilt_rad - edge_rad);
  EXPECT_NEAR(moment / sum, 0.5 * (right_px + left_px), 0.02);
}

}  // namespace
}  // namespace lineservo::vehicle
