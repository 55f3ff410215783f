// Wear and light in the image, against the floor that they are said to be on.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>

#include "tests/vehicle/floor/render_oracle.h"
#include "tests/vehicle/floor/test_layouts.h"
#include "vehicle/floor/floor_renderer.h"

namespace lineservo::vehicle {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector2d;
using features::CameraModel;

constexpr std::uint64_t kSeed = 3;

Isometry3d over_a_line() {
  return test::camera_pose({6.0, 0.62, 0.5}, 0.3, 0.08, -0.05);
}

cv::Mat look(const FloorLook& look, const CameraModel& camera, const Isometry3d& X_WC,
             const Layout& layout = test::warehouse()) {
  FloorRenderer renderer(layout, camera, look, kSeed);
  cv::Mat bgr;
  renderer.render(X_WC, bgr);
  return bgr;
}

FloorLook worn_and_dirty() {
  FloorLook look;
  look.wear.worn_share = 0.25;
  look.wear.gap_m = 0.1;
  look.wear.dirt_share = 0.02;
  look.wear.objects_per_m2 = 2.0;
  return look;
}

const PaintShape* top_at(const std::vector<const PaintShape*>& shapes, const Vector2d& p_W) {
  const auto it =
      std::find_if(shapes.rbegin(), shapes.rend(), [&](const PaintShape* s) { return s->paints(p_W); });
  return it == shapes.rend() ? nullptr : *it;
}

TEST(FloorLook, EveryPixelIsTheMeanOfTheWornFloor) {
  const CameraModel camera({160, 120, 80.0, 80.0, 79.5, 59.5, {}});
  const Layout layout = test::warehouse();
  Decals decals(layout, worn_and_dirty().wear, kSeed);
  const std::vector<PaintShape> paint = paint_of(layout);
  for (const Isometry3d& X_WC : {over_a_line(), test::camera_pose({4.3, 0.7, 0.5}, -0.8, -0.1, 0.12)}) {
    decals.look_near(X_WC.translation().head<2>(), 1.5);
    const auto colour_at = [&](const Vector2d& p) {
      if (const PaintShape* lying = top_at(decals.on_top(), p)) return lying->colour;
      const bool is_painted =
          std::any_of(paint.begin(), paint.end() - 1, [&](const PaintShape& s) { return s.paints(p); });
      return is_painted && !top_at(decals.holes(), p) ? test::kYellow : test::kGrey;
    };
    EXPECT_GT(decals.on_top().size() + decals.holes().size(), 20U);
    const cv::Mat bgr = look(worn_and_dirty(), camera, X_WC);
    for (const cv::Rect& window :
         {cv::Rect(50, 0, 50, 20), cv::Rect(0, 70, 40, 25), cv::Rect(110, 100, 50, 20)})
      EXPECT_LE(test::largest_difference(bgr, window, camera, X_WC, colour_at),
                0.06 * 210.0);  // white tape on dark dirt
  }
}

// A pixel is its even colour times the factor, plus the glare: to the rounding of the colour before (1.3
// times a half), of the pixel, and a level for the facets of the light.
void expect_lit(const FloorLook& lit, const CameraModel& camera, const Isometry3d& X_WC) {
  const cv::Mat even = look({}, camera, X_WC), bgr = look(lit, camera, X_WC);
  FloorLight light(lit.light, kSeed);
  light.look_near(X_WC.translation(), 2.0);
  double largest = 0.0;
  for (int v = 0; v < bgr.rows; ++v)
    for (int u = 0; u < bgr.cols; ++u) {
      const Vector2d p_W = test::floor_point(camera, X_WC, {static_cast<double>(u), static_cast<double>(v)});
      const Lighting here = light.at(p_W);
      for (int c = 0; c < 3; ++c) {
        const double expected =
            std::min(255.0, here.factor * even.at<cv::Vec3b>(v, u)[c] + 255.0 * here.glare);
        largest = std::max(largest, std::abs(bgr.at<cv::Vec3b>(v, u)[c] - expected));
      }
    }
  EXPECT_LE(largest, 3.0);
}

TEST(FloorLook, TheLightIsThatOfTheFloorsPlace) {
  FloorLook uneven;
  uneven.light.low = 0.4;
  uneven.light.high = 1.3;
  for (const CameraModel& camera : {test::pinhole(), test::distorting()}) {
    expect_lit(uneven, camera, over_a_line());
    expect_lit(uneven, camera, test::camera_pose({2.0, 2.0, 0.5}, 2.0, -0.1, 0.1));
  }
}

TEST(FloorLook, GlareAndShadowAreWhereTheyFall) {
  FloorLook glare, shadow;
  glare.light.glare = 0.5;
  glare.light.glare_radius_m = 0.4;
  glare.light.glare_every_m = 1.0;
  shadow.light.shadow = 0.6;
  expect_lit(glare, test::pinhole(), over_a_line());
  expect_lit(shadow, test::pinhole(), over_a_line());
}

TEST(FloorLook, OddSizesAreLitToTheLastPixel) {
  FloorLook uneven;
  uneven.light.low = 0.4;
  uneven.light.high = 1.3;
  expect_lit(uneven, CameraModel({157, 123, 80.0, 80.0, 78.0, 61.0, {}}), over_a_line());
}

TEST(FloorLook, WithoutAnyTheFrameIsTheSame) {
  EXPECT_EQ(cv::norm(
                look({}, test::pinhole(), over_a_line()),
                [] {
                  FloorRenderer renderer(test::warehouse(), test::pinhole());
                  cv::Mat bgr;
                  renderer.render(over_a_line(), bgr);
                  return bgr;
                }(),
                cv::NORM_INF),
            0.0);
}

}  // namespace
}  // namespace lineservo::vehicle
