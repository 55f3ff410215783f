#include "features/detect/image_detector.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "features/line/line_methods.h"
#include "tests/features/detect/floor_pictures.h"

namespace lineservo::features {
namespace {

using namespace test;

constexpr double kStripe_m = 0.08;

Floor along(double heading_rad, double width_m = kStripe_m) {
  return node_floor({heading_rad, heading_rad + kPi}, width_m);
}

/// The centreline through the floor's origin, in the picture.
ImageLine true_line(const MaskGeometry& geometry, const Pose& pose, double heading_rad) {
  const Eigen::Vector2d way(std::cos(heading_rad), std::sin(heading_rad));
  return line_through(pixel_of(geometry, pose, -0.1 * way), pixel_of(geometry, pose, 0.1 * way));
}

/// Both lines cross the middle of the true one at nearly the same place and angle.
void expect_same_line(const ImageLine& line, const ImageLine& truth, double within_px, double within_deg) {
  const double x = 0.5 * (truth.begin.x + truth.end.x), y = 0.5 * (truth.begin.y + truth.end.y);
  EXPECT_NEAR(x * std::cos(line.theta_rad) + y * std::sin(line.theta_rad), line.rho_px, within_px);
  EXPECT_NEAR(degrees(std::remainder(line.theta_rad - truth.theta_rad, kPi)), 0.0, within_deg);
}

Scene scene_of(LineColor color) {
  Scene scene;
  scene.paint_bgr = paint_of(color);
  scene.floor_bgr = floor_for(color);
  return scene;
}

TEST(ImageDetector, FindsEveryColourUnderUnevenLight) {
  const MaskGeometry geometry = assumed_geometry(320, 240);
  const Pose pose{.x_m = 0.02, .y_m = 0.05, .heading_rad = 0.15};
  for (const LineColor color : kLineColors) {
    Scene scene = scene_of(color);
    scene.light_from = 0.45;
    scene.light_to = 1.05;
    scene.noise = 8.0;
    scene.texture = 6.0;
    const auto seen = ImageDetector().detect(photograph(geometry, pose, along(0.0), scene));
    ASSERT_FALSE(seen.lines.empty()) << name(color);
    EXPECT_EQ(seen.color, color);
    EXPECT_GT(seen.evidence, 0.5);
    EXPECT_EQ(seen.code, JunctionCode::straight);
    expect_same_line(seen.lines.front(), true_line(geometry, pose, 0.0), 1.0, 0.5);
    EXPECT_NEAR(seen.lines.front().width_px, kStripe_m / 0.5 * 160.0, 2.0);
  }
}

TEST(ImageDetector, FindsTheLineThroughShadowGlareAndJoints) {
  const MaskGeometry geometry = assumed_geometry(320, 240);
  const Pose pose{.x_m = 0.0, .y_m = -0.04, .heading_rad = -0.3};
  for (const LineColor color : kLineColors) {
    Scene scene = scene_of(color);
    scene.shadow = 0.55;
    scene.glare = 0.35;
    scene.joints_every_m = 0.3;
    scene.noise = 6.0;
    const auto seen = ImageDetector().detect(photograph(geometry, pose, along(0.0), scene));
    ASSERT_FALSE(seen.lines.empty()) << name(color);
    EXPECT_EQ(seen.color, color);
    expect_same_line(seen.lines.front(), true_line(geometry, pose, 0.0), 2.0, 1.0);
  }
}

TEST(ImageDetector, FollowsConvergingBordersOfATiltedView) {
  const MaskGeometry geometry = assumed_geometry(320, 320);
  for (const double pitch_rad : {-0.5, -0.25, 0.25, 0.5}) {
    const Pose pose{.x_m = 0.0,
                    .y_m = 0.03,
                    .height_m = 0.6,
                    .heading_rad = 0.2,
                    .roll_rad = 0.1,
                    .pitch_rad = pitch_rad};
    const auto seen =
        ImageDetector().detect(photograph(geometry, pose, along(0.0, 0.15), scene_of(LineColor::yellow)));
    ASSERT_FALSE(seen.lines.empty()) << pitch_rad;
    expect_same_line(seen.lines.front(), true_line(geometry, pose, 0.0), 3.2, 1.5);
  }
}

TEST(ImageDetector, TakesGreyImages) {
  const MaskGeometry geometry = assumed_geometry(320, 240);
  const Pose pose{.y_m = 0.03, .heading_rad = 0.1};
  for (const LineColor color : {LineColor::white, LineColor::black}) {
    cv::Mat grey;
    cv::cvtColor(photograph(geometry, pose, along(0.0), scene_of(color)), grey, cv::COLOR_BGR2GRAY);
    const auto seen = ImageDetector().detect(grey);
    ASSERT_FALSE(seen.lines.empty());
    EXPECT_EQ(seen.color, color);
    expect_same_line(seen.lines.front(), true_line(geometry, pose, 0.0), 1.0, 0.5);
  }
}

TEST(ImageDetector, TellsTheJunctionAndItsCentre) {
  const MaskGeometry geometry = assumed_geometry(320, 240);
  const Pose pose{.x_m = 0.05, .y_m = 0.02, .heading_rad = 0.05};
  const Floor cross = node_floor({kAhead, kLeft, kBehind, kRight}, 0.1);
  const auto seen = ImageDetector().detect(photograph(geometry, pose, cross, scene_of(LineColor::black)));
  EXPECT_EQ(seen.code, JunctionCode::cross);
  const PixelPoint centre = pixel_of(geometry, pose, {0.0, 0.0});
  ASSERT_TRUE(seen.junction_px);
  EXPECT_NEAR(seen.junction_px->x, centre.x, 1.5);
  EXPECT_NEAR(seen.junction_px->y, centre.y, 1.5);
  EXPECT_EQ(seen.lines.size(), 2u);
}

TEST(ImageDetector, PrefersTheLineWithAHueAndTellsTheOther) {
  const MaskGeometry geometry = assumed_geometry(320, 240);
  const Pose pose{};
  Scene scene = scene_of(LineColor::yellow);
  cv::Mat both = photograph(geometry, pose, along(0.0), scene);
  scene.paint_bgr = paint_of(LineColor::white);
  Floor beside;
  beside.strips.push_back(Strip({-2.0, 0.3}, {2.0, 0.3}, kStripe_m));
  photograph(geometry, pose, beside, scene)(cv::Rect(0, 0, 120, 240)).copyTo(both(cv::Rect(0, 0, 120, 240)));
  const auto seen = ImageDetector().detect(both);
  EXPECT_EQ(seen.color, LineColor::yellow);
  ASSERT_EQ(seen.lines.size(), 2u);
  EXPECT_NEAR(seen.lines[0].rho_px, 159.5, 1.0);
  EXPECT_NEAR(seen.lines[1].rho_px, 159.5 - 0.3 / 0.5 * 160.0, 1.0);
}

TEST(ImageDetector, FollowsTheLineThatCarriesOn) {
  // Level in the picture, with a stub upwards that measures 0.09 m beyond its border: less than half as long.
  const MaskGeometry geometry = assumed_geometry(320, 240);
  Floor floor = along(kLeft);
  floor.strips.push_back(Strip({0.0, 0.0}, {0.13, 0.0}, kStripe_m));
  const auto seen = ImageDetector().detect(photograph(geometry, {}, floor, scene_of(LineColor::yellow)));
  ASSERT_FALSE(seen.lines.empty());
  EXPECT_NEAR(std::abs(degrees(seen.lines.front().theta_rad)), 90.0, 0.5);
}

TEST(ImageDetector, SeesNoLineOnABareFloor) {
  const MaskGeometry geometry = assumed_geometry(320, 240);
  for (const double joints_m : {0.0, 0.25}) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      Scene scene = scene_of(seed % 2 == 0 ? LineColor::black : LineColor::white);
      scene.joints_every_m = joints_m;
      scene.light_from = 0.5;
      scene.shadow = 0.6;
      scene.noise = 8.0;
      scene.texture = 10.0;
      scene.seed = seed;
      const Pose pose{.heading_rad = 0.4 * static_cast<double>(seed)};
      const auto seen = ImageDetector().detect(photograph(geometry, pose, {}, scene));
      EXPECT_TRUE(seen.lines.empty()) << joints_m << " " << seed;
      EXPECT_FALSE(seen.color);
      EXPECT_EQ(seen.foreground_ratio, 0.0);
    }
  }
}

TEST(ImageDetector, FindsAStripeThatCoversMostOfTheView) {
  const MaskGeometry geometry = assumed_geometry(320, 240);
  for (const LineColor color : kLineColors) {
    for (const double width_m : {0.5, 0.6}) {  // of 1.0 m in view
      for (const double heading_rad : {-0.15, 0.0, 0.1}) {
        const Pose pose{.y_m = 0.03, .heading_rad = heading_rad};
        const auto seen =
            ImageDetector().detect(photograph(geometry, pose, along(0.0, width_m), scene_of(color)));
        ASSERT_FALSE(seen.lines.empty()) << name(color) << width_m << heading_rad;
        EXPECT_EQ(seen.color, color) << width_m << heading_rad;
        SCOPED_TRACE(std::string(name(color)) + " " + std::to_string(width_m) + " " +
                     std::to_string(heading_rad));
        expect_same_line(seen.lines.front(), true_line(geometry, pose, 0.0), 3.0, 1.0);
      }
    }
  }
}

TEST(ImageDetector, FindsLinesOfEightPixels) {
  const MaskGeometry geometry = assumed_geometry(640, 480);
  const Pose pose{.y_m = 0.03, .heading_rad = 0.2};
  for (const LineColor color : kLineColors) {
    const auto seen = ImageDetector().detect(photograph(geometry, pose, along(0.0, 0.0125), scene_of(color)));
    ASSERT_FALSE(seen.lines.empty()) << name(color);
    EXPECT_EQ(seen.color, color);
    expect_same_line(seen.lines.front(), true_line(geometry, pose, 0.0), 2.0, 0.5);
  }
}

TEST(ImageDetector, FindsThinLinesWithAHueInLargePictures) {
  const MaskGeometry geometry = assumed_geometry(1280, 720);
  const Pose pose{.y_m = 0.03, .heading_rad = 0.2};
  for (const LineColor color : {LineColor::yellow, LineColor::red}) {
    // 0.42 % of the width: 5.3 px here, 8 px of 1920.
    const auto seen = ImageDetector().detect(photograph(geometry, pose, along(0.0, 0.0042), scene_of(color)));
    ASSERT_FALSE(seen.lines.empty()) << name(color);
    EXPECT_EQ(seen.color, color);
    expect_same_line(seen.lines.front(), true_line(geometry, pose, 0.0), 2.0, 0.5);
    EXPECT_NEAR(seen.lines.front().width_px, 5.4, 3.0);  // the mask is filtered
  }
}

TEST(ImageDetector, SeesNoLineInShadowsOfAChairNorInPlanks) {
  const MaskGeometry geometry = assumed_geometry(320, 240);
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    Scene chair = scene_of(seed % 2 == 0 ? LineColor::black : LineColor::white), wood = chair;
    chair.leg_shadow = 0.7;
    chair.texture = 4.0;
    wood.planks_m = 0.12;
    wood.plank_tone = 0.17;
    chair.seed = wood.seed = seed;
    const Pose pose{.heading_rad = 0.5 * static_cast<double>(seed)};
    EXPECT_TRUE(ImageDetector().detect(photograph(geometry, pose, {}, chair)).lines.empty()) << seed;
    EXPECT_TRUE(ImageDetector().detect(photograph(geometry, pose, {}, wood)).lines.empty()) << seed;
  }
}

TEST(ImageDetector, AnswersInPixelsOfTheImageAsGiven) {
  const MaskGeometry geometry = assumed_geometry(960, 720);
  const Pose pose{.x_m = 0.02, .y_m = 0.05, .heading_rad = 0.15};
  const auto seen = ImageDetector().detect(photograph(geometry, pose, along(0.0), scene_of(LineColor::red)));
  ASSERT_FALSE(seen.lines.empty());
  expect_same_line(seen.lines.front(), true_line(geometry, pose, 0.0), 1.0, 0.2);
  EXPECT_GE(seen.lines.front().begin.y, -0.5);
  EXPECT_LE(seen.lines.front().begin.y, 719.5);
}

TEST(ImageDetector, TakesTheLensOutOfTheBorders) {
  CameraParameters camera{.width_px = 320,
                          .height_px = 240,
                          .fx_px = 160.0,
                          .fy_px = 160.0,
                          .cx_px = 159.5,
                          .cy_px = 119.5,
                          .distortion = {-0.15, 0.03, 0.0, 0.0, 0.0}};
  const MaskGeometry geometry(CameraModel(camera), 320, 240);
  const Pose pose{.y_m = 0.0};
  const cv::Mat picture = photograph(geometry, pose, along(0.0), scene_of(LineColor::red));
  ImageDetectorOptions options;
  options.camera = camera;
  const auto seen = ImageDetector(options).detect(picture);
  ASSERT_FALSE(seen.lines.empty());
  expect_same_line(seen.lines.front(), true_line(geometry, pose, 0.0), 1.0, 0.3);
  EXPECT_THROW(ImageDetector(options).detect(picture(cv::Rect(0, 0, 319, 240))), std::invalid_argument);
}

TEST(ImageDetector, ALineWhoseMiddleIsOutOfViewEndsWhereItsPaintDoes) {
  const MaskGeometry geometry = assumed_geometry(320, 240);
  // The middle of the two arms lies 0.025 m below the view.
  const Pose pose{.x_m = 0.4, .y_m = 0.0, .heading_rad = 0.001};
  const Floor cross = node_floor({0.0, kPi / 2, kPi, -kPi / 2}, 0.36);
  const auto seen = ImageDetector().detect(photograph(geometry, pose, cross, scene_of(LineColor::yellow)));
  ASSERT_EQ(seen.lines.size(), 2u);
  for (const PixelPoint& end : {seen.lines[1].begin, seen.lines[1].end}) {
    EXPECT_NEAR(end.x, 159.5, 162.0);
    EXPECT_NEAR(end.y, 247.5, 4.0);
  }
}

TEST(ImageDetector, LooksForOneColourWhenTold) {
  const MaskGeometry geometry = assumed_geometry(320, 240);
  const cv::Mat picture = photograph(geometry, {}, along(0.0), scene_of(LineColor::red));
  ImageDetectorOptions options;
  options.segmenter.colors = {LineColor::yellow};
  EXPECT_TRUE(ImageDetector(options).detect(picture).lines.empty());
  options.segmenter.colors = {LineColor::red};
  EXPECT_FALSE(ImageDetector(options).detect(picture).lines.empty());
}

TEST(ImageDetector, TakesImagesFromSixteenPixels) {
  EXPECT_NO_THROW(ImageDetector().detect(cv::Mat(16, 16, CV_8UC3, cv::Scalar::all(90))));
  EXPECT_NO_THROW(ImageDetector().detect(cv::Mat(16, 2000, CV_8UC1, cv::Scalar::all(90))));
  EXPECT_THROW(ImageDetector().detect(cv::Mat(15, 16, CV_8UC3)), std::invalid_argument);
  EXPECT_THROW(ImageDetector().detect(cv::Mat()), std::invalid_argument);
}

TEST(AutoSegmenter, GivesTheMaskOfThePaint) {
  const MaskGeometry geometry = assumed_geometry(320, 240);
  const Floor floor = along(0.0);
  AutoSegmenter segmenter;
  const PackedMask mask =
      segmenter.segment(photograph(geometry, {}, floor, scene_of(LineColor::yellow)), {320, 240});
  PackedMask truth(320, 240);
  for_each_pixel(geometry, {},
                 [&](int x, int y, const Eigen::Vector2d& p) { truth.set(x, y, floor.covers(p)); });
  int wrong = 0;
  for (int y = 0; y < 240; ++y)
    for (int x = 0; x < 320; ++x) wrong += int{mask.at(x, y) != truth.at(x, y)};
  EXPECT_LE(wrong, 2 * 240);  // a pixel at each border
  EXPECT_EQ(segmenter.color(), LineColor::yellow);
  EXPECT_GT(segmenter.evidence(), 0.8);
  EXPECT_EQ(segmenter.segment(cv::Mat(240, 320, CV_8UC3, cv::Scalar::all(90)), {320, 240}).count(), 0);
  EXPECT_FALSE(segmenter.color());
}

TEST(ImageDetector, EveryLineMethodFindsTheLineOfAPlainPicture) {
  const MaskGeometry geometry = assumed_geometry(320, 240);
  const Pose pose{.x_m = 0.02, .y_m = 0.05, .heading_rad = 0.15};
  const cv::Mat picture = photograph(geometry, pose, along(0.0), scene_of(LineColor::yellow));
  for (const LineMethod& method : line_methods()) {
    ImageDetectorOptions options;
    options.method = std::string(method.name);
    const ImageDetection seen = ImageDetector(options).detect(picture);
    ASSERT_FALSE(seen.lines.empty()) << method.name;
    if (method.name == "naive") continue;  // finds a border, half a width off
    expect_same_line(seen.lines.front(), true_line(geometry, pose, 0.0), 6.0, 4.0);
  }
  ImageDetectorOptions unknown;
  unknown.method = "stripes";
  EXPECT_THROW(ImageDetector{unknown}, std::invalid_argument);
}

}  // namespace
}  // namespace lineservo::features
