#include "apps/track/track_import.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "apps/config/layout_file.h"
#include "apps/flight/mission.h"
#include "tests/apps/test_files.h"

namespace lineservo::apps {
namespace {

using testing::complaint;
using ::testing::HasSubstr;

const cv::Scalar kFloor(110, 110, 110), kPaint(0, 200, 230);
constexpr double kMetresPerPixel = 0.01;

/// A T: 3 m from left to right, 1.2 m up from its middle, lines of 0.09 m.
cv::Mat tee() {
  cv::Mat image(200, 360, CV_8UC3, kFloor);
  cv::rectangle(image, {30, 146}, {329, 154}, kPaint, cv::FILLED);
  cv::rectangle(image, {176, 30}, {184, 150}, kPaint, cv::FILLED);
  return image;
}

class TrackImportTest : public ::testing::Test {
 protected:
  vehicle::Layout traced(const cv::Mat& image) const {
    TrackImportOptions options;
    options.name = "traced";
    options.metres_per_pixel = kMetresPerPixel;
    return read_layout(
        temp_.write("traced.yaml", layout_of_track(paint_of_image(image, "x.png"), options, "x.png")));
  }
  static bool has_node_at(const vehicle::Layout& layout, double x_m, double y_m) {
    return std::any_of(layout.nodes.begin(), layout.nodes.end(), [&](const vehicle::LayoutNode& node) {
      return (node.p_W - Eigen::Vector2d(x_m, y_m)).norm() < 0.02;
    });
  }
  const testing::TempFolder temp_;
};

TEST_F(TrackImportTest, ATeeHasFourNodesAndThreeLinesOfItsWidth) {
  const vehicle::Layout layout = traced(tee());
  EXPECT_EQ(layout.nodes.size(), 4u);
  ASSERT_EQ(layout.edges.size(), 3u);
  EXPECT_TRUE(has_node_at(layout, 0.30, 0.49));
  EXPECT_TRUE(has_node_at(layout, 1.80, 0.49));
  EXPECT_TRUE(has_node_at(layout, 3.29, 0.49));
  EXPECT_TRUE(has_node_at(layout, 1.80, 1.69));
  for (const vehicle::LayoutEdge& edge : layout.edges) EXPECT_NEAR(edge.width_m, 0.09, 0.011);
  EXPECT_EQ(layout.edges[0].colour, (vehicle::Bgr{0, 200, 230}));
  EXPECT_EQ(layout.floor_colour, (vehicle::Bgr{110, 110, 110}));
}

TEST_F(TrackImportTest, ACornerBecomesANodeAndACircleARound) {
  cv::Mat corner(200, 300, CV_8UC3, kFloor);
  cv::rectangle(corner, {30, 146}, {204, 154}, kPaint, cv::FILLED);
  cv::rectangle(corner, {196, 30}, {204, 154}, kPaint, cv::FILLED);
  EXPECT_TRUE(has_node_at(traced(corner), 2.00, 0.49));
  cv::Mat ring(300, 300, CV_8UC3, kFloor);
  cv::circle(ring, {150, 150}, 100, kPaint, 8);
  const vehicle::Layout layout = traced(ring);
  ASSERT_EQ(layout.edges.size(), 1u);
  EXPECT_NEAR(layout.edges[0].centreline.length_m(), 6.28, 0.1);
}

TEST_F(TrackImportTest, TheTracedFloorIsFlown) {
  traced(tee());
  FlightRequest request;
  request.layout = (temp_.path() / "traced.yaml").string();
  request.instruction = "node:n2";
  apply_conditions(request, "ideal");
  EXPECT_EQ(fly_mission(prepare(request)).summary.outcome, "arrived");
}

TEST_F(TrackImportTest, ImagesWithoutLinesAreRefused) {
  const cv::Mat bare(100, 100, CV_8UC3, kFloor);
  EXPECT_THAT(complaint([&] { paint_of_image(bare, "x.png"); }), HasSubstr("x.png: no line differs"));
  cv::Mat dirty = bare.clone();
  cv::rectangle(dirty, {50, 50}, {52, 52}, kPaint, cv::FILLED);
  EXPECT_THAT(complaint([&] { paint_of_image(dirty, "x.png"); }), HasSubstr("x.png: no line was found"));
}

}  // namespace
}  // namespace lineservo::apps
