#include "vehicle/floor/floor_renderer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>
#include <stdexcept>
#include <vector>

#include "features/geometry/angles.h"
#include "tests/vehicle/floor/render_oracle.h"
#include "tests/vehicle/floor/test_layouts.h"

namespace lineservo::vehicle {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector2d;
using features::CameraModel;
using features::radians;
using test::camera_pose;

// 0.05 px of an edge is 5 % of a pixel's area; the largest contrast is the blue of grey against yellow.
constexpr double kEdgeTolerance_px = 0.05;
constexpr double kAreaTolerance_levels = kEdgeTolerance_px * 120.0;

cv::Mat render(const Layout& layout, const CameraModel& camera, const Isometry3d& X_WC) {
  FloorRenderer renderer(layout, camera);
  cv::Mat bgr;
  renderer.render(X_WC, bgr);
  return bgr;
}

bool same(const cv::Mat& a, const cv::Mat& b) {
  return cv::norm(a, b, cv::NORM_INF) == 0.0;
}

// Poses over the origin: level, tilted to both sides, and steep.
std::vector<Isometry3d> poses_over(double x_m, double y_m, double height_m) {
  const Eigen::Vector3d p_WB(x_m, y_m, height_m);
  return {camera_pose(p_WB, 0.0, 0.0, 0.0), camera_pose(p_WB, 0.4, 0.0, 0.0),
          camera_pose(p_WB, -1.1, radians(20.0), radians(-10.0)),
          camera_pose(p_WB, 2.3, radians(-12.0), radians(30.0))};
}

// ---- Edges against the projected floor edge -------------------------------------------------------------

// How far past `left` the yellow on the left of a row reaches, from the blue channel: its covered area.
double yellow_extent_px(const cv::Mat& bgr, int row, int left, int right) {
  double extent_px = 0.0;
  for (int u = left; u < right; ++u) extent_px += (120.0 - bgr.at<cv::Vec3b>(row, u)[0]) / 120.0;
  return extent_px;
}

// The same from the camera model: where the paint ends along the row, by bisection, averaged over 32 lines
// across the row's height.
double projected_extent_px(const CameraModel& camera, const Isometry3d& X_WC, int row, int left, int right,
                           const test::FloorPredicate& is_painted) {
  constexpr int kLines = 32;
  double sum_px = 0.0;
  for (int line = 0; line < kLines; ++line) {
    const double v = row + (line + 0.5) / kLines - 0.5;
    double inside = left - 0.5, outside = right - 0.5;
    for (int step = 0; step < 40; ++step) {
      const double middle = 0.5 * (inside + outside);
      (is_painted(test::floor_point(camera, X_WC, {middle, v})) ? inside : outside) = middle;
    }
    sum_px += inside - (left - 0.5);
  }
  return sum_px / kLines;
}

// Every row in which one border leads from paint on the left to floor on the right: the largest error, and in
// how many rows it was measured.
struct EdgeErrors {
  double largest_px = 0.0;
  int rows = 0;
};
EdgeErrors edge_errors(const Layout& layout, const CameraModel& camera, const Isometry3d& X_WC,
                       const test::FloorPredicate& is_painted) {
  const cv::Mat bgr = render(layout, camera, X_WC);
  EdgeErrors errors;
  for (int row = 0; row < bgr.rows; ++row) {
    int right = -1;
    for (int u = 12; u < bgr.cols - 12 && right < 0; ++u)
      if (bgr.at<cv::Vec3b>(row, u - 12)[0] == 0 && bgr.at<cv::Vec3b>(row, u + 12)[0] == 120) right = u + 12;
    if (right < 0) continue;
    const int left = right - 24;
    const double error_px = yellow_extent_px(bgr, row, left, right) -
                            projected_extent_px(camera, X_WC, row, left, right, is_painted);
    errors.largest_px = std::max(errors.largest_px, std::abs(error_px));
    ++errors.rows;
  }
  return errors;
}

void expect_exact_edges(const Layout& layout, const std::vector<Isometry3d>& poses,
                        const test::FloorPredicate& is_painted) {
  for (const CameraModel& camera : {test::pinhole(), test::distorting()})
    for (const Isometry3d& X_WC : poses) {
      const EdgeErrors errors = edge_errors(layout, camera, X_WC, is_painted);
      EXPECT_LE(errors.largest_px, kEdgeTolerance_px);
      EXPECT_GE(errors.rows, 40);
    }
}

TEST(FloorRendererEdges, OfAStraightStripe) {
  const Layout layout = test::single_line({-5.0, -1.0}, {5.0, 1.0}, 0.3);
  const Vector2d normal = Vector2d(-1.0, 5.0).normalized();
  std::vector<Isometry3d> poses = poses_over(0.1, 0.05, 0.5);
  poses.erase(poses.begin() + 2);  // it looks along the rows
  expect_exact_edges(layout, poses, [&](const Vector2d& p) { return std::abs(normal.dot(p)) <= 0.15; });
}

TEST(FloorRendererEdges, OfAnArc) {
  const Layout layout = test::circle(1.5, 0.2);
  Layout unmarked = layout;
  unmarked.start_markers.clear();
  expect_exact_edges(unmarked, poses_over(1.45, 0.1, 0.5),
                     [](const Vector2d& p) { return std::abs(p.norm() - 1.5) <= 0.1; });
}

TEST(FloorRendererEdges, OfADisc) {
  Layout layout = test::single_line({5.0, 5.0}, {6.0, 5.0}, 0.1);
  layout.end_markers.push_back({{0.0, 0.0}, 0.18, test::kYellow});
  expect_exact_edges(layout, poses_over(0.03, 0.02, 0.5), [](const Vector2d& p) { return p.norm() <= 0.18; });
}

// ---- Every pixel against 256 samples ----------------------------------------------------------------

constexpr double kHalf_m = 0.18;

bool within(double value) {
  return std::abs(value) <= kHalf_m;
}

// Where several borders cross a pixel it is worth 64 samples, one or two of which may be on the wrong side of
// each.
constexpr double kNodeTolerance_levels = 0.06 * 120.0;

// A camera of few pixels sees the whole neighbourhood of the node: all of them are checked. Its tiles span
// 22°, eight times those of a full-size camera, so the slope of the lens distortion changes much within one.
CameraModel coarse(const std::array<double, 5>& distortion) {
  return CameraModel({80, 60, 40.0, 40.0, 39.3, 29.8, distortion});
}

void expect_areas(const Layout& layout, const test::FloorColour& colour_at,
                  double tolerance_levels = kNodeTolerance_levels) {
  const CameraModel plain = coarse({}), distorted = coarse({-0.20, 0.05, 0.001, -0.0005, 0.0});
  for (const Isometry3d& X_WC : poses_over(0.05, 0.02, 0.5)) {
    EXPECT_LE(test::largest_difference(render(layout, plain, X_WC), {0, 0, 80, 60}, plain, X_WC, colour_at),
              tolerance_levels);
    EXPECT_LE(
        test::largest_difference(render(layout, distorted, X_WC), {0, 0, 80, 60}, distorted, X_WC, colour_at),
        1.5 * tolerance_levels);
  }
}

TEST(FloorRendererNodes, ACornerHasNoNotch) {
  expect_areas(test::star({0.0, radians(90.0)}, 0.36), test::yellow_where([](const Vector2d& p) {
                 return (p.x() >= -kHalf_m && within(p.y())) || (p.y() >= -kHalf_m && within(p.x()));
               }));
}

// The last tiles hold one column and one row of pixels; the rest of them lies where this lens has folded
// over.
TEST(FloorRendererNodes, TheLensPastTheImageDoesNotMatter) {
  const CameraModel camera({33, 17, 23.2, 23.2, 16.0, 8.0, {-0.2, 0.0, 0.0, 0.0, 0.0}});
  const auto colour_at = test::yellow_where([](const Vector2d& p) {
    return (p.x() >= -kHalf_m && within(p.y())) || (p.y() <= kHalf_m && within(p.x()));
  });
  const Layout corner = test::star({0.0, radians(-90.0)}, 0.36);
  for (const Isometry3d& X_WC : poses_over(0.05, 0.02, 0.5))
    EXPECT_LE(test::largest_difference(render(corner, camera, X_WC), {32, 0, 1, 17}, camera, X_WC, colour_at),
              1.5 * kNodeTolerance_levels);
}

TEST(FloorRendererNodes, ATeeHasNoSeam) {
  expect_areas(
      test::star({0.0, radians(180.0), radians(-90.0)}, 0.36),
      test::yellow_where([](const Vector2d& p) { return within(p.y()) || (p.y() <= 0.0 && within(p.x())); }));
}

TEST(FloorRendererNodes, ACrossHasNoSeam) {
  expect_areas(test::star({0.0, radians(90.0), radians(180.0), radians(-90.0)}, 0.36),
               test::yellow_where([](const Vector2d& p) { return within(p.y()) || within(p.x()); }));
}

TEST(FloorRendererNodes, ABendOf45DegreesHasNoNotch) {
  const Vector2d u(std::cos(radians(135.0)), std::sin(radians(135.0))), n(-u.y(), u.x());
  expect_areas(test::star({0.0, radians(135.0)}, 0.36), test::yellow_where([&](const Vector2d& p) {
                 return p.norm() <= kHalf_m || (p.x() >= 0.0 && within(p.y())) ||
                        (u.dot(p) >= 0.0 && within(n.dot(p)));
               }));
}

TEST(FloorRendererNodes, AnArcGoesOnFromAStraightWithoutASeam) {
  Layout layout = test::bend(0.36, 1.5);
  for (LayoutNode& node : layout.nodes) node.p_W.x() -= 1.0;
  layout.edges.clear();
  test::add_line(layout, 0, 1, 0.36);
  layout.edges.push_back(
      {1, 2, Curve::arc(layout.nodes[1].p_W, layout.nodes[2].p_W, {0.0, 1.5}, true), 0.36});
  expect_areas(layout, test::yellow_where([](const Vector2d& p) {
                 if (p.x() <= 0.0) return p.x() >= -1.0 && within(p.y());
                 const Vector2d from_centre = p - Vector2d(0.0, 1.5);
                 return from_centre.x() <= -from_centre.y() && within(from_centre.norm() - 1.5);
               }));
}

TEST(FloorRendererNodes, MarkersLieOnTop) {
  Layout layout = test::star({0.0, radians(90.0)}, 0.36);
  layout.start_markers.push_back({{0.0, 0.0}, 0.18});
  expect_areas(layout, [](const Vector2d& p) {
    if (p.norm() <= 0.18) return test::kRed;
    return (p.x() >= -kHalf_m && within(p.y())) || (p.y() >= -kHalf_m && within(p.x())) ? test::kYellow
                                                                                        : test::kGrey;
  });
}

TEST(FloorRendererNodes, LaterEdgesOfAnotherColourLieOnTop) {
  Layout layout = test::star({0.0, radians(180.0), radians(90.0), radians(-90.0)}, 0.36);
  layout.edges[2].colour = layout.edges[3].colour = test::kRed;
  expect_areas(layout, [](const Vector2d& p) {
    if (within(p.x())) return test::kRed;
    return within(p.y()) ? test::kYellow : test::kGrey;
  });
}

// Stripes of less than a pixel: 2 cm from 3 m with a pixel of 7.5 cm.
TEST(FloorRendererNodes, ThinStripesKeepTheirArea) {
  const Layout layout = test::star({0.0, radians(90.0), radians(180.0), radians(-90.0)}, 0.02);
  const CameraModel camera = coarse({});
  const Isometry3d X_WC = camera_pose({0.01, 0.02, 3.0}, 0.3, 0.1, 0.0);
  const auto is_painted = [](const Vector2d& p) {
    return std::abs(p.x()) <= 0.01 || std::abs(p.y()) <= 0.01;
  };
  EXPECT_LE(test::largest_difference(render(layout, camera, X_WC), {0, 0, 80, 60}, camera, X_WC,
                                     test::yellow_where(is_painted)),
            kAreaTolerance_levels);
}

// The windows of a full-size frame around a node's corners and edges.
TEST(FloorRendererNodes, AFullSizeWarehouseFrame) {
  const double x_W = 4.2, y_W = 0.6 + 6.8 / 3.0;
  const auto colour_at =
      test::yellow_where([&](const Vector2d& p) { return within(p.x() - x_W) || within(p.y() - y_W); });
  const Isometry3d X_WC = camera_pose({x_W + 0.02, y_W - 0.03, 0.5}, 0.2, 0.05, -0.08);
  for (const CameraModel& camera : {test::pinhole(), test::distorting()}) {
    const cv::Mat bgr = render(test::warehouse(), camera, X_WC);
    for (const cv::Rect& window :
         {cv::Rect(180, 100, 60, 40), cv::Rect(400, 320, 60, 40), cv::Rect(0, 60, 40, 60)})
      EXPECT_LE(test::largest_difference(bgr, window, camera, X_WC, colour_at), kAreaTolerance_levels);
  }
}

// ---- Everything else ------------------------------------------------------------------------------------

// Paint out of view changes nothing: the grid's other edges against the four in view.
TEST(FloorRenderer, CullingChangesNothing) {
  const Layout whole = test::warehouse();
  Layout near = whole;
  const std::size_t node = 1 * 5 + 1;
  std::erase_if(near.edges, [&](const LayoutEdge& edge) { return edge.from != node && edge.to != node; });
  near.start_markers.clear();
  std::vector<Isometry3d> poses = poses_over(4.1, 0.5 + 6.8 / 3.0, 0.25);
  poses.pop_back();  // it sees as far as the next nodes
  for (const CameraModel& camera : {test::pinhole(), test::distorting()})
    for (const Isometry3d& X_WC : poses)
      EXPECT_TRUE(same(render(whole, camera, X_WC), render(near, camera, X_WC)));
}

TEST(FloorRenderer, ShowsSkyAboveTheHorizon) {
  const CameraModel camera = test::pinhole();
  const double tilt_rad = radians(70.0);
  const cv::Mat bgr = render(test::single_line({0.0, 0.0}, {40.0, 0.0}, 0.36), camera,
                             camera_pose({0.0, 0.0, 0.5}, 0.0, -tilt_rad, 0.0));
  // The horizon is 20° above the axis: 320 tan 20° = 116.5 px.
  const double horizon_px = 239.5 - 320.0 * std::tan(radians(90.0) - tilt_rad);
  const auto row_above = static_cast<int>(horizon_px) - 2, row_below = static_cast<int>(horizon_px) + 8;
  EXPECT_EQ(bgr.at<cv::Vec3b>(row_above, 320), bgr.at<cv::Vec3b>(0, 0));
  EXPECT_NE(bgr.at<cv::Vec3b>(0, 0), cv::Vec3b(120, 120, 120));
  EXPECT_EQ(bgr.at<cv::Vec3b>(row_below, 10), cv::Vec3b(120, 120, 120));
  EXPECT_EQ(bgr.at<cv::Vec3b>(479, 320), cv::Vec3b(0, 200, 230));
}

TEST(FloorRenderer, SizesThatAreNoMultipleOfATile) {
  const CameraModel camera({77, 53, 40.0, 40.0, 38.0, 26.0, {}});
  const Isometry3d X_WC = camera_pose({0.0, 0.0, 0.5}, 0.3, 0.0, 0.0);
  const Layout layout = test::single_line({-5.0, 0.0}, {5.0, 0.0}, 0.36);
  const auto colour_at = test::yellow_where([](const Vector2d& p) { return within(p.y()); });
  const cv::Mat bgr = render(layout, camera, X_WC);
  EXPECT_EQ(bgr.size(), cv::Size(77, 53));
  EXPECT_LE(test::largest_difference(bgr, {0, 0, 77, 53}, camera, X_WC, colour_at), kAreaTolerance_levels);
}

TEST(FloorRenderer, OnTheFloorItStillDraws) {
  const cv::Mat bgr = render(test::single_line({-1.0, 0.0}, {1.0, 0.0}, 0.36), test::pinhole(),
                             camera_pose({0.0, 0.0, -0.01}, 0.0, 0.0, 0.0));
  EXPECT_EQ(bgr.at<cv::Vec3b>(240, 320), cv::Vec3b(0, 200, 230));
}

TEST(FloorRenderer, KeepsTheImagesMemory) {
  FloorRenderer renderer(test::warehouse(), test::pinhole());
  cv::Mat bgr;
  renderer.render(camera_pose({4.2, 0.6, 0.5}, 0.0, 0.0, 0.0), bgr);
  const cv::Mat first = bgr.clone();
  const std::uint8_t* memory = bgr.data;
  renderer.render(camera_pose({6.0, 1.0, 0.5}, 1.0, 0.2, 0.0), bgr);
  EXPECT_EQ(bgr.data, memory);
  EXPECT_FALSE(same(bgr, first));
  renderer.render(camera_pose({4.2, 0.6, 0.5}, 0.0, 0.0, 0.0), bgr);
  EXPECT_TRUE(same(bgr, first));
}

TEST(FloorRenderer, RefusesALayoutWithFaults) {
  EXPECT_THROW(FloorRenderer(Layout{}, test::pinhole()), std::invalid_argument);
}

// FNV-1a of the bytes.
std::uint64_t hash_of(const cv::Mat& bgr) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (int row = 0; row < bgr.rows; ++row)
    for (int i = 0; i < 3 * bgr.cols; ++i) hash = (hash ^ bgr.ptr(row)[i]) * 0x100000001b3ULL;
  return hash;
}

// The same bits whatever the processor: change these only with a change of the drawing that is meant.
TEST(FloorRenderer, GoldenFrames) {
  const Isometry3d over_corner = camera_pose({0.65, 0.55, 0.5}, 0.2, 0.05, -0.08);
  EXPECT_EQ(hash_of(render(test::warehouse(), test::pinhole(), over_corner)), 18083176115259266728U);
  EXPECT_EQ(hash_of(render(test::warehouse(), test::distorting(), over_corner)), 1688576976606921804U);
  EXPECT_EQ(hash_of(render(test::circle(), test::pinhole(), camera_pose({0.2, -5.2, 0.5}, 0.2, 0.1, 0.0))),
            11184517297089201450U);
}

}  // namespace
}  // namespace lineservo::vehicle
