#pragma once

#include <Eigen/Geometry>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "features/geometry/level_view.h"
#include "tests/vehicle/floor/render_oracle.h"
#include "tests/vehicle/floor/test_layouts.h"
#include "vehicle/floor/floor_renderer.h"
#include "vehicle/floor/image_noise.h"

namespace lineservo::support {

/// A frame of the down camera, and the tilt at its exposure.
struct FlightFrame {
  cv::Mat bgr;
  features::LevelView view;
};

/// What the floor and the camera are like.
struct FlightScene {
  std::string name;
  double line_width_m = 0.36;
  double noise_levels = 0.0;  ///< standard deviation
  bool worn = false;          ///< a quarter of the paint rubbed off in blotches, stains of paint beside it
};

inline std::vector<FlightScene> flight_scenes() {
  return {{"clean"},
          {.name = "tape", .line_width_m = 0.05},
          {.name = "noisy", .noise_levels = 2.0},
          {.name = "worn", .noise_levels = 2.0, .worn = true},
          {.name = "worn_tape", .line_width_m = 0.05, .noise_levels = 2.0, .worn = true}};
}

/// The place a share of the way along a13: row 0 to column 1, up to row 3.
inline Eigen::Vector3d place_on_a13(double share) {
  constexpr double row_m = 3.6, column_m = 6.8, height_m = 0.5;
  const double gone_m = share * (row_m + column_m);
  if (gone_m < row_m) return {0.6 + gone_m, 0.6, height_m};
  return {0.6 + row_m, 0.6 + gone_m - row_m, height_m};
}

/// Discs of one colour until about a share of the picture is covered.
inline void blot(cv::Mat& bgr, cv::RNG& random, double share, double radius_px, const cv::Scalar& colour) {
  const double mean_area_px = features::kPi * radius_px * radius_px / 3.0;
  const int discs = static_cast<int>(-std::log1p(-share) * bgr.cols * bgr.rows / mean_area_px);
  for (int k = 0; k < discs; ++k) {
    const cv::Point centre(random.uniform(0, bgr.cols), random.uniform(0, bgr.rows));
    cv::circle(bgr, centre, static_cast<int>(random.uniform(0.0, radius_px)), colour, cv::FILLED);
  }
}

/// `count` frames along a13 with the offsets and tilts of a flight. Deterministic.
inline std::vector<FlightFrame> frames_along_a13(const FlightScene& scene, int count) {
  using namespace vehicle;
  FloorRenderer renderer(test::warehouse(scene.line_width_m), test::pinhole());
  const ImageNoise noise(scene.noise_levels / 255.0, 1);
  cv::RNG random(7);
  std::vector<FlightFrame> frames;
  for (int k = 0; k < count; ++k) {
    const double share = (k + 0.5) / count;
    const double heading_rad = (share * 10.4 < 3.6 ? 0.0 : features::kPi / 2.0) + random.gaussian(0.03);
    const double roll_rad = random.gaussian(0.01), pitch_rad = random.gaussian(0.01);
    const Eigen::Vector3d off_m(random.gaussian(0.01), random.gaussian(0.01), random.gaussian(0.005));
    FlightFrame frame{{}, features::LevelView(roll_rad, pitch_rad)};
    renderer.render(test::camera_pose(place_on_a13(share) + off_m, heading_rad, pitch_rad, roll_rad),
                    frame.bgr);
    if (scene.worn) {
      blot(frame.bgr, random, 0.25, 26.0, {120, 120, 120});
      blot(frame.bgr, random, 0.02, 10.0, {0, 200, 230});
    }
    noise.add(k, frame.bgr);
    frames.push_back(std::move(frame));
  }
  return frames;
}

}  // namespace lineservo::support
