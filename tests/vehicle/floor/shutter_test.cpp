#include "vehicle/floor/shutter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <stdexcept>

#include "tests/vehicle/floor/render_oracle.h"
#include "tests/vehicle/floor/test_layouts.h"
#include "vehicle/floor/floor_renderer.h"

namespace lineservo::vehicle {
namespace {

using Eigen::Isometry3d;
using features::CameraModel;

constexpr double kHeight_m = 0.5, kFocal_px = 320.0;

ShutterOptions shutter(double exposure_s, double readout_s, int samples = 5) {
  ShutterOptions options;
  options.exposure_s = exposure_s;
  options.readout_s = readout_s;
  options.samples = samples;
  return options;
}

/// Level and at a constant velocity, facing +x: over the point (x, y) at mid-exposure.
ShutterWarp::Motion sliding(double x_m, double y_m, double vx_m_s, double vy_m_s) {
  return [=](double t_s) {
    return test::camera_pose({x_m + vx_m_s * t_s, y_m + vy_m_s * t_s, kHeight_m}, 0.0, 0.0, 0.0);
  };
}

cv::Mat exposed(const Layout& layout, const CameraModel& camera, const ShutterOptions& options,
                const ShutterWarp::Motion& motion) {
  FloorRenderer renderer(layout, camera);
  ShutterWarp warp(renderer.grid(), options);
  cv::Mat bgr;
  renderer.render(motion, warp, bgr);
  return bgr;
}

// How much of a pixel is painted yellow, from the blue of grey.
double painted(const cv::Mat& bgr, int row, int column) {
  return 1.0 - bgr.at<cv::Vec3b>(row, column)[0] / 120.0;
}

// The share of [a, b] that is above the edge e.
double share_above(double edge, double a, double b) {
  return std::clamp((b - edge) / (b - a), 0.0, 1.0);
}

// ∫ of the above over edges that move evenly from e₀ to e₁: a box convolved with a box.
double box_convolution(double first_edge, double last_edge, double a, double b) {
  constexpr int kSteps = 4000;
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i)
    sum += share_above(first_edge + (i + 0.5) / kSteps * (last_edge - first_edge), a, b) / kSteps;
  return sum;
}

// At t the ray (x, y) sees the floor that mid-exposure sees along (x − v_y t/h, y − v_x t/h): image x is to
// the right, image y to the back.
TEST(ShutterWarp, AConstantVelocityShiftsAllRaysAlike) {
  const TileGrid grid(test::pinhole());
  const ShutterOptions options = shutter(0.02, 0.01, 4);
  ShutterWarp warp(grid, options);
  warp.follow(sliding(1.0, 2.0, 0.8, -0.3));
  ShutterWarp::Rays moved;
  for (int k = 0; k < 4; ++k)
    for (const auto& [row, column] : {std::pair{0, 0}, {29, 13}, {59, 39}}) {
      warp.rays(row, column, k, moved);
      const TileRays still = grid.rays(row, column);
      for (int i = 0; i < kTilePixels; ++i) {
        const int v = row * kTileHeight_px + i / kTileWidth_px;
        const double t_s = row_delay_s(options, v + 0.5, 480) + sample_delay_s(options, k);
        ASSERT_NEAR(moved.x[i] - still.x[i], 0.3 * t_s / kHeight_m, 2e-6);
        ASSERT_NEAR(moved.y[i] - still.y[i], -0.8 * t_s / kHeight_m, 2e-6);
      }
    }
}

// A border across the way: at 2 m/s and 8 ms it is smeared over 10.24 px.
TEST(Shutter, ABlurredEdgeIsTheBoxConvolutionOfTheSharpOne) {
  const double blur_px = 2.0 * 0.008 * kFocal_px / kHeight_m;
  const Layout across = test::single_line({1.13, -5.0}, {1.13, 5.0}, 0.3);  // its near border at x = 0.98
  const cv::Mat bgr = exposed(across, test::pinhole(), shutter(0.008, 0.0, 32), sliding(1.0, 0.0, 2.0, 0.0));
  const double edge_px = 239.5 + 0.02 * kFocal_px / kHeight_m;  // painted above it
  for (int v = 230; v < 275; ++v) {
    const double bare = box_convolution(edge_px - 0.5 * blur_px, edge_px + 0.5 * blur_px, v - 0.5, v + 0.5);
    EXPECT_NEAR(painted(bgr, v, 100), 1.0 - bare, 0.012) << v;
  }
}

TEST(Shutter, FiveSamplesAreTheMeanOfFiveSharpEdges) {
  const double blur_px = 2.0 * 0.008 * kFocal_px / kHeight_m;
  const Layout across = test::single_line({1.13, -5.0}, {1.13, 5.0}, 0.3);
  const cv::Mat bgr = exposed(across, test::pinhole(), shutter(0.008, 0.0), sliding(1.0, 0.0, 2.0, 0.0));
  for (int v = 230; v < 275; ++v) {
    double bare = 0.0;
    for (int k = 0; k < 5; ++k) {
      const double edge_px = 239.5 + 0.02 * kFocal_px / kHeight_m + ((k + 0.5) / 5.0 - 0.5) * blur_px;
      bare += share_above(edge_px, v - 0.5, v + 0.5) / 5.0;
    }
    EXPECT_NEAR(painted(bgr, v, 100), 1.0 - bare, 0.006) << v;
  }
}

// A line along the way, flown over sideways: row v sees it v_y f/h · delay(v) to the right of where it is.
TEST(Shutter, ARollingShutterSkewsALineByTheSpeedTimesTheRowsTime) {
  const ShutterOptions options = shutter(0.0, 0.015);
  const cv::Mat bgr = exposed(test::single_line({-5, 0}, {5, 0}, 0.2), test::pinhole(), options,
                              sliding(0.0, 0.01, 0.0, 1.5));
  for (int v = 0; v < 480; ++v) {
    double sum = 0.0, moment = 0.0;
    for (int u = 0; u < 640; ++u) {
      sum += painted(bgr, v, u);
      moment += painted(bgr, v, u) * u;
    }
    const double y_m = 0.01 + 1.5 * row_delay_s(options, v + 0.5, 480);
    ASSERT_NEAR(moment / sum, 319.5 + y_m * kFocal_px / kHeight_m, 0.02) << v;
    ASSERT_NEAR(sum, 0.2 * kFocal_px / kHeight_m, 0.02) << v;
  }
}

// Each row of the exposure against that row of whole frames, drawn sharp from the poses at its own instants.
void expect_rows_of_sharp_frames(const CameraModel& camera, const ShutterWarp::Motion& motion) {
  const ShutterOptions options = shutter(0.008, 0.015);
  const Layout layout = test::warehouse();
  const cv::Mat bgr = exposed(layout, camera, options, motion);
  FloorRenderer sharp(layout, camera);
  cv::Mat frame;
  double largest = 0.0;
  for (int v = 3; v < bgr.rows; v += 17) {
    cv::Mat mean = cv::Mat::zeros(1, bgr.cols, CV_64FC3);
    for (int k = 0; k < options.samples; ++k) {
      sharp.render(motion(row_delay_s(options, v + 0.5, bgr.rows) + sample_delay_s(options, k)), frame);
      cv::Mat row;
      frame.row(v).convertTo(row, CV_64FC3, 1.0 / options.samples);
      mean += row;
    }
    cv::Mat drawn;
    bgr.row(v).convertTo(drawn, CV_64FC3);
    largest = std::max(largest, cv::norm(drawn, mean, cv::NORM_INF));
  }
  EXPECT_LE(largest, 0.06 * 120.0);  // of a pixel of an edge
}

// Turning at 60 and 90 degrees a second, tilting, climbing, over the corner of a node.
TEST(Shutter, AnyMotionIsThatOfEachRowAtItsTime) {
  const auto tumbling = [](double t_s) {
    return test::camera_pose({4.25 + 0.7 * t_s, 0.66 - 0.4 * t_s, 0.5 + 0.5 * t_s}, 0.4 + 1.5 * t_s,
                             0.1 + 1.0 * t_s, -0.05 - 1.0 * t_s);
  };
  expect_rows_of_sharp_frames(test::pinhole(), tumbling);
  expect_rows_of_sharp_frames(test::distorting(), tumbling);
}

TEST(Shutter, StandingStillItIsTheSharpFrame) {
  const Isometry3d X_WC = test::camera_pose({4.25, 0.66, 0.5}, 0.4, 0.1, -0.05);
  const cv::Mat bgr =
      exposed(test::warehouse(), test::pinhole(), shutter(0.008, 0.015), [&](double) { return X_WC; });
  FloorRenderer sharp(test::warehouse(), test::pinhole());
  cv::Mat frame;
  sharp.render(X_WC, frame);
  EXPECT_LE(cv::norm(bgr, frame, cv::NORM_INF), 1.0);
}

TEST(Shutter, RefusesWhatIsOutOfBounds) {
  EXPECT_THROW(shutter(-0.001, 0.0).validate(), std::invalid_argument);
  EXPECT_THROW(shutter(0.0, 0.2).validate(), std::invalid_argument);
  EXPECT_THROW(shutter(0.008, 0.0, 0).validate(), std::invalid_argument);
  EXPECT_THROW(shutter(std::nan(""), 0.0).validate(), std::invalid_argument);
}

}  // namespace
}  // namespace lineservo::vehicle
