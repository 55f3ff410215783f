#pragma once

#include <opencv2/core/types.hpp>
#include <vector>

#include "apps/calibrate/board.h"
#include "features/geometry/camera_model.h"

namespace lineservo::apps {

/// A camera fitted to views of a board.
struct Calibration {
  features::CameraParameters camera;  ///< with k1, k2, p1, p2; k3 stays 0
  double error_px = 0.0;  ///< root mean square over all corners, of their distance to the projection
  std::vector<double> view_errors_px;  ///< the same of each view
};

/// ViSP's camera, whose lens is u = u0 + px x (1 + kud r²) and backwards x = x_d (1 + kdu r_d²).
struct VispCalibration {
  features::CameraParameters camera;  ///< kud is distortion[0], the rest is 0
  double kdu = 0.0;
  double error_px = 0.0;
};

using BoardViews = std::vector<std::vector<cv::Point2f>>;  ///< find_board() of each image

constexpr std::size_t kFewestViews = 3;

/// Zhang's method (OpenCV). Throws InputError for fewer than kFewestViews views, and for views that do not
/// determine the camera: the board held the same way in all, or a focal length of σ > 1 %.
Calibration calibrate(const BoardViews& views, const Board& board, cv::Size image_size);

/// The same with the one coefficient of ViSP, fitted by itself: k1 of the five is not the best single one.
/// kdu is the least-squares inverse over the image.
VispCalibration calibrate_visp(const BoardViews& views, const Board& board, cv::Size image_size);

}  // namespace lineservo::apps
