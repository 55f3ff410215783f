#include "apps/overlay/overlay.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>

#include "apps/overlay/ink.h"
#include "features/geometry/angles.h"
#include "tests/apps/test_floors.h"

namespace lineservo::apps {
namespace {

using features::LevelView;

const cv::Scalar kGround(120, 130, 140);

features::CameraParameters small_camera() {
  features::CameraParameters camera;
  camera.width_px = 160;
  camera.height_px = 120;
  camera.fx_px = camera.fy_px = 80.0;
  camera.cx_px = 79.5;
  camera.cy_px = 59.5;
  return camera;
}

features::LineFeature line_between(features::LevelPoint begin, features::LevelPoint end) {
  features::LineFeature line;
  line.begin = begin;
  line.end = end;
  line.theta_rad = std::atan2(end.x - begin.x, begin.y - end.y);
  return line;
}

features::JunctionFeature junction_at(features::LevelPoint centre) {
  features::JunctionFeature junction;
  junction.centre = centre;
  return junction;
}

bool has_colour(const cv::Mat& picture, cv::Point2d at, const cv::Scalar& colour) {
  const cv::Vec3b pixel =
      picture.at<cv::Vec3b>(static_cast<int>(std::lround(at.y)), static_cast<int>(std::lround(at.x)));
  return pixel == cv::Vec3b(static_cast<uchar>(colour[0]), static_cast<uchar>(colour[1]),
                            static_cast<uchar>(colour[2]));
}

/// The same where a thin line is blended with what is below.
bool is_like(const cv::Mat& picture, cv::Point2d at, const cv::Scalar& colour) {
  const cv::Vec3b pixel =
      picture.at<cv::Vec3b>(static_cast<int>(std::lround(at.y)), static_cast<int>(std::lround(at.x)));
  return cv::norm(cv::Scalar(pixel[0], pixel[1], pixel[2]), colour) < 90.0;
}

/// A frame without anything on it, and what is seen of it.
class OverlayTest : public ::testing::Test {
 protected:
  explicit OverlayTest(const features::CameraParameters& camera = {})
      : frame_(camera.height_px, camera.width_px, CV_8UC3, kGround), camera_(camera) {
    scene_.bgr = &frame_;
  }
  cv::Mat picture() {
    Overlay overlay(camera_, {"test", "law", 0.1});
    return overlay.draw(scene_).clone();
  }
  cv::Mat camera_part() { return picture()(cv::Rect(0, 0, frame_.cols, frame_.rows)).clone(); }
  bool shows(double x, double y, const cv::Scalar& colour) { return has_colour(picture(), {x, y}, colour); }
  bool is_plain() { return cv::norm(camera_part(), frame_, cv::NORM_INF) == 0.0; }

  cv::Mat frame_;
  features::CameraParameters camera_;
  OverlayScene scene_;
};

TEST_F(OverlayTest, DrawsNothingOfWhatIsAbsent) {
  EXPECT_TRUE(is_plain());
}

TEST_F(OverlayTest, DrawsTheLineToFollowWhereItIsFromItsBeginToItsEnd) {
  scene_.features.lines = {line_between({0.1, 0.5}, {0.1, -0.5})};
  const cv::Mat drawn = picture();
  for (const double y : {-0.45, -0.3, 0.0, 0.2, 0.4})
    EXPECT_TRUE(has_colour(drawn, {319.5 + 32.0, 239.5 + 320.0 * y}, ink::kBlue)) << y;
  for (const double y : {-0.6, 0.6})
    EXPECT_TRUE(has_colour(drawn, {319.5 + 32.0, 239.5 + 320.0 * y}, kGround)) << y;
  EXPECT_TRUE(has_colour(drawn, {319.5 + 32.0, 239.5 - 160.0}, ink::kBlue)) << "a disc at the end";
  EXPECT_TRUE(has_colour(drawn, {319.5 + 27.0, 239.5 + 160.0}, ink::kBlue)) << "a ring at the begin";
}

// With κ = 0.8 towards +x the arc from (0, ½) to (0, −½) lies ½ · 0.8 · ¼ = 0.1 to the left of its chord.
TEST_F(OverlayTest, DrawsACurvedLineAlongItsCurve) {
  features::LineFeature line = line_between({0.0, 0.5}, {0.0, -0.5});
  line.curvature = 0.8;
  scene_.features.lines = {line};
  EXPECT_TRUE(shows(319.5 - 32.0, 239.5, ink::kBlue));
  EXPECT_TRUE(shows(319.5, 239.5, kGround));
}

// Nose down by 0.1 the point straight below is f tan 0.1 ahead of the optical axis.
TEST_F(OverlayTest, DrawsAJunctionWhereATiltedCameraSeesIt) {
  scene_.view = LevelView(0.0, 0.1);
  scene_.features.junction = junction_at({0.0, 0.0});
  EXPECT_TRUE(shows(319.5, 239.5 - 320.0 * std::tan(0.1), ink::kVermilion));
  EXPECT_TRUE(shows(319.5, 239.5, kGround));
}

TEST_F(OverlayTest, DrawsAJunctionWhereTheLensShowsIt) {
  camera_.distortion = {-0.05, 0.0, 0.0, 0.0, 0.0};
  scene_.features.junction = junction_at({0.5, 0.0});
  EXPECT_TRUE(shows(319.5 + 320.0 * 0.5 * (1.0 - 0.05 * 0.25), 239.5, ink::kVermilion));
}

TEST_F(OverlayTest, DrawsTheArmsOfAJunctionToTheirSides) {
  scene_.features.junction = junction_at({0.0, 0.0});
  scene_.features.junction->arms = {{0.0, 0.4}, {0.5 * features::kPi, 0.3}};
  const cv::Mat drawn = picture();
  EXPECT_TRUE(has_colour(drawn, {319.5, 239.5 - 120.0}, ink::kVermilion)) << "forward";
  EXPECT_TRUE(has_colour(drawn, {319.5 - 90.0, 239.5}, ink::kVermilion)) << "left";
  EXPECT_TRUE(has_colour(drawn, {319.5, 239.5 + 90.0}, kGround)) << "back";
  EXPECT_TRUE(has_colour(drawn, {319.5 - 104.0, 239.5}, kGround)) << "beyond its length";
}

TEST_F(OverlayTest, DrawsNothingThatLiesBehindTheCameraOrFarOutOfView) {
  scene_.view = LevelView(0.0, 1.2);
  scene_.features.junction = junction_at({0.0, -3.0});
  EXPECT_TRUE(is_plain());
  scene_.view = LevelView();
  scene_.features.junction = junction_at({1e6, std::nan("")});
  scene_.features.lines = {line_between({1e7, 0.0}, {1e7, 1.0})};
  EXPECT_TRUE(is_plain());
}

// Laws whose paper does not correct for tilt have their features in the camera as it hangs.
TEST_F(OverlayTest, DrawsTheLawsFeaturesInTheCameraThatTheyLieIn) {
  scene_.view = LevelView(0.0, 0.1);
  scene_.features.law.target = features::LevelPoint{0.25, 0.0};
  EXPECT_TRUE(shows(319.5 + 80.0, 239.5, ink::kPurple));
  scene_.features.law = {};
  scene_.features.law.centroid = features::LevelPoint{0.0, 0.25};
  EXPECT_TRUE(shows(319.5, 239.5 + 80.0, ink::kGreen));
}

TEST_F(OverlayTest, OutlinesTheMaskAndLeavesWhatIsInside) {
  features::PackedMask mask(640, 480);
  for (int y = 100; y < 300; ++y)
    for (int x = 150; x < 250; ++x) mask.set(x, y);
  scene_.mask = &mask;
  const cv::Mat drawn = picture();
  for (const double x : {150.0, 249.0}) EXPECT_TRUE(is_like(drawn, {x, 200.0}, ink::kSky)) << x;
  for (const double y : {100.0, 299.0}) EXPECT_TRUE(is_like(drawn, {200.0, y}, ink::kSky)) << y;
  for (const double x : {145.0, 155.0, 245.0, 255.0})
    EXPECT_TRUE(has_colour(drawn, {x, 200.0}, kGround)) << x;
}

// A pixel of the mask is 1.6 by 1.2 of the frame's.
TEST_F(OverlayTest, AResizedMaskLiesWhereItsPixelsDo) {
  features::PackedMask mask(400, 400);
  for (int y = 100; y < 300; ++y)
    for (int x = 150; x < 250; ++x) mask.set(x, y);
  scene_.mask = &mask;
  const cv::Mat drawn = picture();
  EXPECT_TRUE(is_like(drawn, {150.5 * 1.6 - 0.5, 240.0}, ink::kSky));
  EXPECT_TRUE(is_like(drawn, {320.0, 299.5 * 1.2 - 0.5}, ink::kSky));
}

TEST_F(OverlayTest, AMaskThatFillsTheFrameHasNoOutline) {
  features::PackedMask mask(400, 400);
  for (int y = 0; y < 400; ++y)
    for (int x = 0; x < 400; ++x) mask.set(x, y);
  scene_.mask = &mask;
  EXPECT_TRUE(is_plain());
}

TEST_F(OverlayTest, ShowsWhereACommandLeads) {
  scene_.command = servo::VelocityCommand{0.1, -0.05, 0.0, 0.0};
  const cv::Mat drawn = picture();
  EXPECT_TRUE(has_colour(drawn, {320.0, 239.5 - 60.0}, ink::kBlack)) << "forward is up";
  EXPECT_TRUE(has_colour(drawn, {319.5 + 25.0, 240.0}, ink::kBlack)) << "right is right";
  EXPECT_TRUE(has_colour(drawn, {320.0, 239.5 - 95.0}, kGround)) << "90 px long";
  EXPECT_TRUE(has_colour(drawn, {319.5 - 25.0, 240.0}, kGround));
  EXPECT_TRUE(has_colour(drawn, {320.0, 239.5 + 60.0}, kGround));
}

TEST_F(OverlayTest, ShowsToWhichSideACommandTurns) {
  scene_.command = servo::VelocityCommand{0.0, 0.0, 0.0, 0.8};
  const auto on_arc = [](double angle_rad) {
    return cv::Point2d(319.5 - 62.0 * std::sin(angle_rad), 239.5 - 62.0 * std::cos(angle_rad));
  };
  const cv::Mat drawn = picture();
  EXPECT_TRUE(has_colour(drawn, on_arc(0.4), ink::kBlack)) << "counter-clockwise";
  EXPECT_TRUE(has_colour(drawn, on_arc(-0.4), kGround));
  EXPECT_TRUE(has_colour(drawn, on_arc(1.2), kGround)) << "by what a second turns";
}

TEST_F(OverlayTest, ShowsAnAttitudeAsWhereItLeads) {
  scene_.command = servo::AttitudeCommand{features::radians(2.5), features::radians(5.0), 0.0, 0.5};
  const cv::Mat drawn = picture();
  EXPECT_TRUE(has_colour(drawn, {320.0, 239.5 - 60.0}, ink::kBlack)) << "nose down: forward";
  EXPECT_TRUE(has_colour(drawn, {319.5 + 25.0, 240.0}, ink::kBlack)) << "right side down: right";
}

TEST_F(OverlayTest, ATickWithoutAFrameShowsTheLastOneDarkened) {
  Overlay overlay(camera_, {"test", "law", 0.1});
  overlay.draw(scene_);
  scene_.bgr = nullptr;
  EXPECT_TRUE(has_colour(overlay.draw(scene_), {500.0, 400.0}, 0.4 * kGround));
}

TEST_F(OverlayTest, TextsChangeWithWhatTheyTell) {
  const cv::Mat before = picture();
  scene_.next = servo::NodeSignature{};
  scene_.next->code = features::JunctionCode::cross;
  EXPECT_GT(cv::norm(picture(), before, cv::NORM_INF), 100.0);
  EXPECT_TRUE(is_plain());
}

class SmallOverlayTest : public OverlayTest {
 protected:
  SmallOverlayTest() : OverlayTest(small_camera()) {}
};

TEST_F(SmallOverlayTest, EnlargesSmallFramesByAWholeFactor) {
  Overlay overlay(camera_, {"test", "law", 0.1});
  EXPECT_EQ(overlay.zoom(), 4);
  EXPECT_EQ(overlay.size().height, 480);
  EXPECT_GT(overlay.size().width, 640);
  scene_.features.junction = junction_at({0.25, -0.25});
  EXPECT_TRUE(shows((79.5 + 20.0 + 0.5) * 4.0 - 0.5, (59.5 - 20.0 + 0.5) * 4.0 - 0.5, ink::kVermilion));
}

TEST(Overlay, TallFramesAreEnlargedNoMoreThanTheyCanBeShown) {
  features::CameraParameters camera = small_camera();
  camera.width_px = 17;
  camera.height_px = 333;
  EXPECT_EQ(Overlay(camera, {"test", "law", 0.1}).zoom(), 3);
}

TEST(Overlay, EverySideIsEvenAsVideosWantIt) {
  for (const int width_px : {17, 161, 641, 1001}) {
    features::CameraParameters camera = small_camera();
    camera.width_px = width_px;
    camera.height_px = 333;
    const cv::Size size = Overlay(camera, {"test", "law", 0.1}).size();
    EXPECT_EQ(size.width % 2, 0);
    EXPECT_EQ(size.height % 2, 0);
  }
}

class MapTest : public ::testing::Test {
 protected:
  MapTest() : overlay_({}, {"test", "law", 0.1}, floor_, plan_) {}

  cv::Mat map_with(const Eigen::Vector2d& p_W, double heading_rad = 0.0) {
    OverlayScene scene;
    scene.vehicle = MapPose{p_W, heading_rad};
    return overlay_.draw(scene)(overlay_.map_place()).clone();
  }
  cv::Point2d at(double x_m, double y_m) const { return overlay_.map()->at({x_m, y_m}); }

  vehicle::Layout floor_ = testing::shipped_layout("warehouse");
  servo::Plan plan_ = testing::plan_on(floor_, "a13");
  Overlay overlay_;
};

TEST_F(MapTest, ShowsThePaintWithYUp) {
  const cv::Mat map = map_with({7.8, 2.9});
  EXPECT_TRUE(is_like(map, at(11.4, 8.5), {0, 200, 230})) << "a line";
  EXPECT_TRUE(has_colour(map, at(9.6, 4.0), {120, 120, 120})) << "the floor between";
  EXPECT_LT(at(0.6, 7.4).y, at(0.6, 0.6).y);
  EXPECT_LT(at(0.6, 0.6).x, at(18.6, 0.6).x);
}

TEST_F(MapTest, ShowsTheVehicleAndThePathThatItHasFlown) {
  map_with({4.2, 0.6});
  map_with({4.2, 5.1});
  const cv::Mat map = map_with({12.0, 5.1});
  EXPECT_TRUE(has_colour(map, at(12.0, 5.1), ink::kVermilion));
  EXPECT_TRUE(is_like(map, at(4.2, 3.0), ink::kBlue)) << "along the line";
  EXPECT_TRUE(is_like(map, at(9.0, 5.1), ink::kBlue)) << "and across";
}

TEST_F(MapTest, TheVehiclePointsWhereItHeads) {
  const double pixel_m = 1.0 / (at(1.0, 0.0).x - at(0.0, 0.0).x);
  const double nose_m = 6.0 * pixel_m;
  const cv::Mat north = map_with({9.6, 4.0}, 0.5 * features::kPi);
  EXPECT_TRUE(has_colour(north, at(9.6, 4.0 + 0.6 * nose_m), ink::kVermilion));
  EXPECT_FALSE(has_colour(north, at(9.6, 4.0 - 1.2 * nose_m), ink::kVermilion));
}

}  // namespace
}  // namespace lineservo::apps
