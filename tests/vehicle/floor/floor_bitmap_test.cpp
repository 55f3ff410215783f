#include "vehicle/floor/floor_bitmap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "tests/vehicle/floor/floor_from_above.h"
#include "tests/vehicle/floor/test_layouts.h"
#include "vehicle/floor/shutter.h"

namespace lineservo::vehicle {
namespace {

using test::camera_pose;

constexpr double kMetresPerPixel = 0.01;

cv::Mat plain(int width_px, int height_px, const cv::Scalar& bgr) {
  return {height_px, width_px, CV_8UC3, bgr};
}

Layout floor_of(const cv::Mat& bgr, const Eigen::Vector2d& origin_W = Eigen::Vector2d::Zero()) {
  Layout layout = test::single_line({0.0, 0.0}, {3.0, 0.0}, 0.1);
  layout.bitmap = std::make_shared<const FloorBitmap>(bgr, kMetresPerPixel, origin_W);
  return layout;
}

cv::Mat seen(const Layout& layout, const Eigen::Isometry3d& X_WC, const FloorLook& look = {}) {
  FloorRenderer renderer(layout, test::pinhole(), look, 1);
  cv::Mat bgr;
  renderer.render(X_WC, bgr);
  return bgr;
}

TEST(FloorBitmap, RefusesWhatIsNoPictureOfAFloor) {
  const cv::Mat image = plain(20, 20, {});
  const Eigen::Vector2d origin(0.0, 0.0);
  EXPECT_NO_THROW(FloorBitmap(image, 0.01, origin));
  EXPECT_THROW(FloorBitmap({}, 0.01, origin), std::invalid_argument);
  EXPECT_THROW(FloorBitmap(cv::Mat(20, 20, CV_8UC1), 0.01, origin), std::invalid_argument);
  for (const double size_m : {0.0, -0.01, 2.0, 1e-5, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(FloorBitmap(image, size_m, origin), std::invalid_argument) << size_m;
  EXPECT_THROW(FloorBitmap(image, 0.01, {0.0, std::numeric_limits<double>::infinity()}),
               std::invalid_argument);
}

TEST(FloorBitmap, HalvesItsCopiesForCamerasThatSeeMoreWithAPixel) {
  const FloorBitmap bitmap(plain(101, 64, {10, 20, 30}), 0.01, {0.0, 0.0});
  EXPECT_EQ(bitmap.level_for(0.001), 0);
  EXPECT_EQ(bitmap.level_for(0.0199), 0);
  EXPECT_EQ(bitmap.level_for(0.0201), 1);
  EXPECT_EQ(bitmap.level_for(0.05), 2);
  EXPECT_EQ(bitmap.level(1).cols, 51);
  EXPECT_EQ(bitmap.level(1).rows, 32);
  EXPECT_EQ(bitmap.level(2).at<cv::Vec3b>(15, 25), cv::Vec3b(10, 20, 30));
  const cv::Mat& coarsest = bitmap.level(bitmap.level_for(1e6));
  EXPECT_GE(std::min(coarsest.rows, coarsest.cols), 8);
}

TEST(FloorBitmap, IsSeenWhereItLiesAndTheFloorAroundIt) {
  // 1 m by 0.6 m about (5, 2).
  const Layout layout = floor_of(plain(100, 60, {10, 200, 60}), {4.505, 1.705});
  const features::CameraModel camera = test::pinhole();
  const Eigen::Isometry3d X_WC = camera_pose({5.1, 2.1, 1.0}, 0.4, 0.05, -0.08);
  const cv::Mat bgr = seen(layout, X_WC);
  for (int v = 0; v < bgr.rows; v += 7) {
    for (int u = 0; u < bgr.cols; u += 7) {
      const Eigen::Vector2d p =
          test::floor_point(camera, X_WC, {double(u), double(v)}) - Eigen::Vector2d(5.0, 2.0);
      const double beyond_m = std::max(std::abs(p.x()) - 0.5, std::abs(p.y()) - 0.3);
      if (std::abs(beyond_m) < 1e-4) continue;
      EXPECT_EQ(bgr.at<cv::Vec3b>(v, u), beyond_m < 0.0 ? cv::Vec3b(10, 200, 60) : cv::Vec3b(120, 120, 120));
    }
  }
}

// x to the right and y up: a ramp is what interpolation gives back exactly.
TEST(FloorBitmap, IsInterpolatedBetweenItsPixels) {
  cv::Mat ramp(200, 200, CV_8UC3);
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 200; ++x)
      ramp.at<cv::Vec3b>(y, x) = {static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(199 - y), 7};
  const features::CameraModel camera = test::pinhole();
  const Eigen::Isometry3d X_WC = camera_pose({1.0, 0.9, 0.4}, 2.0, -0.1, 0.07);
  const cv::Mat bgr = seen(floor_of(ramp), X_WC);
  for (int v = 0; v < bgr.rows; v += 5) {
    for (int u = 0; u < bgr.cols; u += 5) {
      const Eigen::Vector2d p = test::floor_point(camera, X_WC, {double(u), double(v)});
      EXPECT_NEAR(bgr.at<cv::Vec3b>(v, u)[0], p.x() / kMetresPerPixel, 0.51);
      EXPECT_NEAR(bgr.at<cv::Vec3b>(v, u)[1], p.y() / kMetresPerPixel, 0.51);
      EXPECT_EQ(bgr.at<cv::Vec3b>(v, u)[2], 7);
    }
  }
}

// The picture of a floor that the renderer drew, flown over, is what the renderer draws; but for the pixels
// along its borders, which a bitmap makes a pixel of its own softer.
TEST(FloorBitmap, LooksLikeTheFloorThatItIsAPictureOf) {
  const Layout drawn = test::warehouse();
  for (const double metres_per_pixel : {0.001, 0.002}) {
    Layout pictured = drawn;
    pictured.bitmap = test::floor_from_above(drawn, {3.2, 1.9}, static_cast<int>(2.0 / metres_per_pixel),
                                             static_cast<int>(2.0 / metres_per_pixel), metres_per_pixel)
                          .bitmap();
    const Eigen::Isometry3d X_WC = camera_pose({4.3, 2.8, 0.5}, 0.3, 0.03, -0.02);
    const cv::Mat exact = seen(drawn, X_WC), bitmap = seen(pictured, X_WC);
    double sum = 0.0;
    int differ = 0;
    for (int v = 0; v < exact.rows; ++v) {
      for (int u = 0; u < exact.cols; ++u) {
        const int off = bitmap.at<cv::Vec3b>(v, u)[0] - exact.at<cv::Vec3b>(v, u)[0];
        sum += off;
        differ += std::abs(off) > 3 ? 1 : 0;
        EXPECT_LE(std::abs(off), 60) << u << ' ' << v;  // half of paint against floor
      }
    }
    const double pixels = static_cast<double>(exact.total());
    EXPECT_LT(differ / pixels, 0.03) << metres_per_pixel;
    EXPECT_LT(std::abs(sum) / pixels, 0.02) << metres_per_pixel << ": no border has moved";
  }
}

TEST(FloorBitmap, FromHighAboveTheMeanOfItsPixelsIsSeen) {
  cv::Mat checks(400, 400, CV_8UC3);
  for (int y = 0; y < 400; ++y)
    for (int x = 0; x < 400; ++x) checks.at<cv::Vec3b>(y, x) = cv::Vec3b::all((x + y) % 2 == 0 ? 0 : 200);
  const cv::Mat bgr = seen(floor_of(checks), camera_pose({2.0, 2.0, 7.0}, 0.3, 0.0, 0.0));
  for (int v = 200; v < 280; ++v)
    for (int u = 280; u < 360; ++u) EXPECT_NEAR(bgr.at<cv::Vec3b>(v, u)[1], 100, 1);
}

TEST(FloorBitmap, MarkersAndWhatIsPaintedOverLieOnIt) {
  Layout layout = floor_of(plain(300, 300, {0, 200, 230}), {-1.5, -1.5});
  layout.start_markers.push_back({{0.0, 0.0}, 0.1});
  FloorLook look;
  look.repaint.cover_W << 0.2, 0.0;
  look.repaint.cover_radius_m = 0.05;
  const cv::Mat bgr = seen(layout, camera_pose({0.0, 0.0, 0.5}, 0.0, 0.0, 0.0), look);
  EXPECT_EQ(bgr.at<cv::Vec3b>(240, 320), cv::Vec3b(40, 40, 220));
  EXPECT_EQ(bgr.at<cv::Vec3b>(112, 320), cv::Vec3b(120, 120, 120));  // 0.2 m ahead
  EXPECT_EQ(bgr.at<cv::Vec3b>(400, 320), cv::Vec3b(0, 200, 230));
}

TEST(FloorBitmap, AnExposureAtRestIsAnInstant) {
  const Layout layout = floor_of(test::floor_from_above(test::warehouse(), {0.0, 0.0}, 300, 300, 0.01).bgr);
  const Eigen::Isometry3d X_WC = camera_pose({0.7, 0.8, 0.5}, 0.3, 0.03, -0.02);
  FloorRenderer renderer(layout, test::pinhole());
  ShutterWarp warp(renderer.grid(), {.exposure_s = 0.008, .readout_s = 0.015, .samples = 5});
  cv::Mat instant, exposed;
  renderer.render(X_WC, instant);
  renderer.render([&](double) { return X_WC; }, warp, exposed);
  EXPECT_LE(cv::norm(instant, exposed, cv::NORM_INF), 1.0);
}

// A step of the floor that passes below during the exposure becomes a ramp as long as the way.
TEST(FloorBitmap, AnExposureInMotionBlurs) {
  cv::Mat step = plain(400, 400, {0, 0, 0});
  step.colRange(200, 400).setTo(cv::Scalar::all(200));
  const Layout layout = floor_of(step, {-1.995, -1.995});
  FloorRenderer renderer(layout, test::pinhole());
  const ShutterOptions options{.exposure_s = 0.01, .readout_s = 0.0, .samples = 5};
  ShutterWarp warp(renderer.grid(), options);
  cv::Mat bgr;
  const double speed_m_s = 10.0;  // 0.1 m in the exposure
  renderer.render(
      [&](double t_s) {
        return camera_pose({speed_m_s * t_s, 0.0, 0.5}, 0.0, 0.0, 0.0);
      },
      warp, bgr);
  EXPECT_EQ(bgr.at<cv::Vec3b>(240 - 45, 320)[1], 200);  // forward is up, 0.07 m
  EXPECT_EQ(bgr.at<cv::Vec3b>(240 + 45, 320)[1], 0);
  EXPECT_NEAR(bgr.at<cv::Vec3b>(240, 320)[1], 100, 25);
  for (int v = 1; v < bgr.rows; ++v)
    EXPECT_LE(bgr.at<cv::Vec3b>(v, 320)[1], bgr.at<cv::Vec3b>(v - 1, 320)[1]) << v;
}

}  // namespace
}  // namespace lineservo::vehicle
