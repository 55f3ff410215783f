#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <functional>
#include <opencv2/core.hpp>

#include "features/geometry/camera_model.h"
#include "features/geometry/level_view.h"
#include "vehicle/floor/layout.h"

// A second, slow and plain way from the floor to the image, for the renderer to be held against.
namespace lineservo::vehicle::test {

using FloorPredicate = std::function<bool(const Eigen::Vector2d&)>;
using FloorColour = std::function<Bgr(const Eigen::Vector2d&)>;

inline constexpr Bgr kGrey = {120, 120, 120};
inline constexpr Bgr kYellow = {0, 200, 230};
inline constexpr Bgr kRed = {40, 40, 220};

/// The pose of the down camera of a body at p_WB with the attitude R_z(yaw) R_y(pitch) R_x(roll).
inline Eigen::Isometry3d camera_pose(const Eigen::Vector3d& p_WB, double yaw_rad, double pitch_rad,
                                     double roll_rad) {
  Eigen::Isometry3d X_WC = Eigen::Isometry3d::Identity();
  X_WC.translation() = p_WB;
  X_WC.linear() = Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix() *
                  features::tilt_R_HB(roll_rad, pitch_rad) * features::down_camera_R_BC();
  return X_WC;
}

inline features::CameraModel pinhole() {
  return features::CameraModel(features::CameraParameters{});
}

inline features::CameraModel distorting() {
  features::CameraParameters parameters;
  parameters.distortion = {-0.20, 0.05, 0.001, -0.0005, 0.0};
  return features::CameraModel(parameters);
}

/// Where the ray of a pixel meets the floor.
inline Eigen::Vector2d floor_point(const features::CameraModel& camera, const Eigen::Isometry3d& X_WC,
                                   features::PixelPoint pixel) {
  const features::NormalizedPoint ray = camera.normalize(pixel);
  const Eigen::Vector3d ray_W = X_WC.linear() * Eigen::Vector3d(ray.x, ray.y, 1.0);
  const Eigen::Vector3d p_W = X_WC.translation() - X_WC.translation().z() / ray_W.z() * ray_W;
  return p_W.head<2>();
}

/// Mean colour of a pixel's square, from the 256 points of a rank-1 lattice: 1/256 of a pixel on upright
/// borders.
inline std::array<double, 3> mean_colour(const features::CameraModel& camera, const Eigen::Isometry3d& X_WC,
                                         int u, int v, const FloorColour& colour_at) {
  constexpr int kPoints = 256, kGenerator = 75;
  std::array<double, 3> sum = {0.0, 0.0, 0.0};
  for (int i = 0; i < kPoints; ++i) {
    const double du = (i + 0.5) / kPoints - 0.5, dv = (i * kGenerator % kPoints + 0.5) / kPoints - 0.5;
    const Bgr colour = colour_at(floor_point(camera, X_WC, {u + du, v + dv}));
    for (std::size_t c = 0; c < 3; ++c) sum[c] += colour[c];
  }
  for (double& channel : sum) channel /= kPoints;
  return sum;
}

/// The largest difference to the oracle, in grey levels, over a window.
inline double largest_difference(const cv::Mat& bgr, const cv::Rect& window,
                                 const features::CameraModel& camera, const Eigen::Isometry3d& X_WC,
                                 const FloorColour& colour_at) {
  double largest = 0.0;
  for (int v = window.y; v < window.y + window.height; ++v)
    for (int u = window.x; u < window.x + window.width; ++u) {
      const std::array<double, 3> expected = mean_colour(camera, X_WC, u, v, colour_at);
      for (int c = 0; c < 3; ++c)
        largest =
            std::max(largest, std::abs(bgr.at<cv::Vec3b>(v, u)[c] - expected[static_cast<std::size_t>(c)]));
    }
  return largest;
}

/// Yellow paint on grey.
inline FloorColour yellow_where(const FloorPredicate& is_painted) {
  return [is_painted](const Eigen::Vector2d& p_W) { return is_painted(p_W) ? kYellow : kGrey; };
}

}  // namespace lineservo::vehicle::test
