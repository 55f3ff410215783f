#include "apps/calibrate/calibration.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/calibrate/camera_text.h"
#include "apps/config/camera/camera_file.h"
#include "tests/apps/test_files.h"
#include "tests/support/chess_boards.h"
#include "tests/support/visp_camera.h"

namespace lineservo::apps {
namespace {

using ::testing::HasSubstr;

const features::CameraParameters kCamera{.width_px = 640,
                                         .height_px = 480,
                                         .fx_px = 420.0,
                                         .fy_px = 425.0,
                                         .cx_px = 325.0,
                                         .cy_px = 236.0,
                                         .distortion = {-0.12, 0.03, 0.001, -0.001, 0.0}};
const Board kBoard;
const cv::Size kSize(640, 480);

const support::ChessBoards& boards() {
  static const support::ChessBoards made(kCamera, kBoard.columns, kBoard.rows, kBoard.square_m);
  return made;
}

/// Corners that were found in the rendered images.
const BoardViews& found_views() {
  static const BoardViews views = [] {
    BoardViews found;
    for (const auto& [rotation, middle_m] : support::board_poses())
      if (auto corners = find_board(boards().render(rotation, middle_m), kBoard)) found.push_back(*corners);
    return found;
  }();
  return views;
}

/// Corners of a board that is moved but never turned, with the noise of a detector.
BoardViews parallel_views(const cv::Vec3d& rotation) {
  const cv::Matx33d k(kCamera.fx_px, 0.0, kCamera.cx_px, 0.0, kCamera.fy_px, kCamera.cy_px, 0.0, 0.0, 1.0);
  cv::RNG random(3);
  BoardViews views;
  for (int view = 0; view < 8; ++view) {
    std::vector<cv::Point2f> corners;
    const cv::Vec3d t(0.02 * view - 0.15, 0.01 * view - 0.1, 0.3 + 0.02 * view);
    cv::projectPoints(board_corners_m(kBoard), rotation, t, k, std::vector<double>{}, corners);
    for (cv::Point2f& corner : corners)
      corner +=
          cv::Point2f(static_cast<float>(random.gaussian(0.02)), static_cast<float>(random.gaussian(0.02)));
    views.push_back(corners);
  }
  return views;
}

TEST(Calibration, FindsTheCameraThatRenderedTheBoards) {
  ASSERT_EQ(found_views().size(), support::board_poses().size());
  const Calibration fit = calibrate(found_views(), kBoard, kSize);
  EXPECT_LT(fit.error_px, 0.1);
  EXPECT_NEAR(fit.camera.fx_px, 420.0, 0.005 * 420.0);
  EXPECT_NEAR(fit.camera.fy_px, 425.0, 0.005 * 425.0);
  EXPECT_NEAR(fit.camera.cx_px, 325.0, 1.0);
  EXPECT_NEAR(fit.camera.cy_px, 236.0, 1.0);
  EXPECT_NEAR(fit.camera.distortion[0], -0.12, 0.01);
  EXPECT_EQ(fit.camera.distortion[4], 0.0);
  ASSERT_EQ(fit.view_errors_px.size(), found_views().size());
  for (const double error_px : fit.view_errors_px) EXPECT_LT(error_px, 0.15);
}

// One coefficient cannot hold the lens, but comes as near as one can.
TEST(Calibration, FitsVispsOneCoefficientByItself) {
  const VispCalibration visp = calibrate_visp(found_views(), kBoard, kSize);
  EXPECT_LT(visp.error_px, 0.5);
  EXPECT_NEAR(visp.camera.fx_px, 420.0, 0.02 * 420.0);
  for (std::size_t k = 1; k < 5; ++k) EXPECT_EQ(visp.camera.distortion[k], 0.0);
}

// There and back over the image: kdu is an approximate inverse of kud, off by a pixel where kdu = 0 is off by
// ten.
TEST(Calibration, KduUndoesKud) {
  const VispCalibration fit = calibrate_visp(found_views(), kBoard, kSize);
  const auto& camera = fit.camera;
  const support::VispCamera visp{camera.fx_px, camera.fy_px,         camera.cx_px,
                                 camera.cy_px, camera.distortion[0], fit.kdu};
  for (const double u : {0.0, 160.0, 480.0, 639.0}) {
    const auto [x, y] = visp.point(u, 100.0);
    const auto [back_u, back_v] = visp.pixel(x, y);
    EXPECT_NEAR(back_u, u, 1.5);
    EXPECT_NEAR(back_v, 100.0, 1.5);
  }
}

TEST(Calibration, ItsFilesReadBackGiveTheSameCamera) {
  const testing::TempFolder temp;
  const Calibration fit = calibrate(found_views(), kBoard, kSize);
  const auto ros = read_camera(temp.write("camera.yaml", ros_text(fit.camera)));
  EXPECT_EQ(ros.width_px, 640);
  EXPECT_EQ(ros.height_px, 480);
  EXPECT_EQ(ros.fx_px, fit.camera.fx_px);
  EXPECT_EQ(ros.fy_px, fit.camera.fy_px);
  EXPECT_EQ(ros.cx_px, fit.camera.cx_px);
  EXPECT_EQ(ros.cy_px, fit.camera.cy_px);
  EXPECT_EQ(ros.distortion, fit.camera.distortion);
  const VispCalibration visp = calibrate_visp(found_views(), kBoard, kSize);
  const std::string file = temp.write("camera.xml", visp_text(visp));
  EXPECT_EQ(read_camera(file).fx_px, visp.camera.fx_px);
  EXPECT_EQ(read_camera(file).distortion, visp.camera.distortion);
  support::VispCamera by_visp;
  ASSERT_TRUE(support::load_visp_camera(by_visp, file, "camera", 640, 480));
  EXPECT_NEAR(by_visp.px, visp.camera.fx_px, 1e-9);
  EXPECT_NEAR(by_visp.v0, visp.camera.cy_px, 1e-9);
  EXPECT_NEAR(by_visp.kud, visp.camera.distortion[0], 1e-12);
  EXPECT_NEAR(by_visp.kdu, visp.kdu, 1e-12);
}

TEST(Calibration, RefusesViewsThatDoNotDetermineTheCamera) {
  for (const cv::Vec3d& rotation : {cv::Vec3d(0, 0, 0), cv::Vec3d(0.4, 0.2, 0.0)})
    EXPECT_THAT(testing::complaint([&] { calibrate(parallel_views(rotation), kBoard, kSize); }),
                HasSubstr("the views do not determine the camera"));
}

TEST(Calibration, RefusesTooFewViews) {
  const BoardViews two(found_views().begin(), found_views().begin() + 2);
  EXPECT_THAT(testing::complaint([&] { calibrate(two, kBoard, kSize); }),
              HasSubstr("a board in 2 images, at least 3 are needed"));
}

}  // namespace
}  // namespace lineservo::apps
