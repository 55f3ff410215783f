#pragma once

#include <cmath>
#include <opencv2/calib3d.hpp>
#include <vector>

#include "features/geometry/camera_model.h"

namespace lineservo::support {

/// Renders chessboards (white, with a white rim) as a camera with a lens sees them: each pixel is the mean of
/// 4×4 rays, exact but for that.
class ChessBoards {
 public:
  ChessBoards(const features::CameraParameters& camera, int columns, int rows, double square_m)
      : camera_(camera), columns_(columns), rows_(rows), square_m_(square_m) {
    const features::CameraModel model(camera);
    for (int y = 0; y < kRays * camera.height_px; ++y)
      for (int x = 0; x < kRays * camera.width_px; ++x)
        rays_.push_back(model.normalize({(x + 0.5) / kRays - 0.5, (y + 0.5) / kRays - 0.5}));
  }

  /// Turned by a rotation vector about its middle, which is at `middle_m` before the camera.
  cv::Mat render(const cv::Vec3d& rotation, const cv::Vec3d& middle_m) const {
    cv::Matx33d r;
    cv::Rodrigues(rotation, r);
    const cv::Vec3d to_middle(0.5 * (columns_ - 1) * square_m_, 0.5 * (rows_ - 1) * square_m_, 0.0);
    const cv::Vec3d t = middle_m - r * to_middle;
    // x ~ [r1 r2 t] (X, Y, 1): the homography from the board to the normalised plane, and its inverse.
    const cv::Matx33d to_board =
        cv::Matx33d(r(0, 0), r(0, 1), t[0], r(1, 0), r(1, 1), t[1], r(2, 0), r(2, 1), t[2]).inv();
    cv::Mat image(camera_.height_px, camera_.width_px, CV_8UC1);
    for (int y = 0; y < image.rows; ++y)
      for (int x = 0; x < image.cols; ++x) image.at<std::uint8_t>(y, x) = pixel(to_board, x, y);
    return image;
  }

 private:
  static constexpr int kRays = 4;

  std::uint8_t pixel(const cv::Matx33d& to_board, int x, int y) const {
    int sum = 0;
    for (int j = 0; j < kRays; ++j)
      for (int i = 0; i < kRays; ++i) sum += level(to_board, ray(kRays * x + i, kRays * y + j));
    return static_cast<std::uint8_t>((sum + kRays * kRays / 2) / (kRays * kRays));
  }
  const features::NormalizedPoint& ray(int x, int y) const {
    return rays_[static_cast<std::size_t>(y * kRays * camera_.width_px + x)];
  }
  int level(const cv::Matx33d& to_board, const features::NormalizedPoint& point) const {
    const cv::Vec3d b = to_board * cv::Vec3d(point.x, point.y, 1.0);
    const double u = b[0] / b[2] / square_m_ + 1.0, v = b[1] / b[2] / square_m_ + 1.0;
    if (u < -1.0 || v < -1.0 || u > columns_ + 2.0 || v > rows_ + 2.0) return 128;
    const bool inside = u >= 0.0 && v >= 0.0 && u < columns_ + 1.0 && v < rows_ + 1.0;
    return inside && (static_cast<int>(u) + static_cast<int>(v)) % 2 == 0 ? 30 : 225;
  }

  features::CameraParameters camera_;
  int columns_, rows_;
  double square_m_;
  std::vector<features::NormalizedPoint> rays_;
};

/// Where a 9x6 board of 25 mm is held for a calibration: tilted to all sides, in the middle and near the
/// corners.
inline std::vector<std::pair<cv::Vec3d, cv::Vec3d>> board_poses() {
  return {{{0.5, 0.0, 0.0}, {0.0, 0.0, 0.32}},    {{-0.5, 0.1, 0.0}, {0.03, 0.0, 0.32}},
          {{0.0, 0.5, 0.1}, {-0.03, 0.02, 0.34}}, {{0.1, -0.5, 0.0}, {0.02, -0.02, 0.34}},
          {{0.3, 0.3, 0.0}, {-0.10, -0.06, 0.4}}, {{-0.3, 0.3, 0.2}, {0.10, -0.06, 0.4}},
          {{0.3, -0.3, 0.0}, {-0.10, 0.07, 0.4}}, {{-0.3, -0.3, -0.1}, {0.10, 0.07, 0.4}}};
}

}  // namespace lineservo::support
