#include "apps/calibrate/calibration.h"

#include <fmt/format.h>

#include <cmath>
#include <opencv2/calib3d.hpp>

#include "apps/config/input_error.h"

namespace lineservo::apps {
namespace {

/// What cv::calibrateCamera returns.
struct Fit {
  cv::Matx33d matrix;
  cv::Mat lens, sigmas, view_errors_px;  ///< sigmas of fx, fy, cx, cy, k1, …
  std::vector<cv::Mat> rotations, translations;
  double error_px = 0.0;
};

[[noreturn]] void refuse(const std::string& why) {
  throw InputError("calibrate: the views do not determine the camera: " + why +
                   "; tilt the board by some 30° to all sides");
}

Fit fitted(const BoardViews& views, const Board& board, cv::Size image_size, int flags) try {
  const std::vector<std::vector<cv::Point3f>> boards(views.size(), board_corners_m(board));
  Fit fit;
  cv::Mat matrix, ignored;
  fit.error_px = cv::calibrateCamera(boards, views, image_size, matrix, fit.lens, fit.rotations,
                                     fit.translations, fit.sigmas, ignored, fit.view_errors_px, flags);
  fit.matrix = matrix;
  return fit;
} catch (const cv::Exception&) {
  refuse("the fit fails");
}

features::CameraParameters parameters(const Fit& fit, cv::Size image_size) {
  features::CameraParameters camera{.width_px = image_size.width,
                                    .height_px = image_size.height,
                                    .fx_px = fit.matrix(0, 0),
                                    .fy_px = fit.matrix(1, 1),
                                    .cx_px = fit.matrix(0, 2),
                                    .cy_px = fit.matrix(1, 2)};
  for (int k = 0; k < 5; ++k) camera.distortion[static_cast<std::size_t>(k)] = fit.lens.at<double>(k);
  return camera;
}

cv::Vec3d normal_of(const cv::Mat& rotation_vector) {
  cv::Matx33d rotation;
  cv::Rodrigues(rotation_vector, rotation);
  return {rotation(0, 2), rotation(1, 2), rotation(2, 2)};
}

/// Parallel boards give the same two constraints again and again (Zhang 2000, §3.1 and appendix D).
double widest_tilt_deg(const std::vector<cv::Mat>& rotations) {
  double least_cosine = 1.0;
  for (const cv::Mat& a : rotations)
    for (const cv::Mat& b : rotations) least_cosine = std::min(least_cosine, normal_of(a).dot(normal_of(b)));
  return std::acos(std::max(least_cosine, -1.0)) * 180.0 / CV_PI;
}

void refuse_degenerate(const Fit& fit) {
  constexpr double kLeastTilt_deg = 10.0, kLargestShare = 0.01;
  if (!cv::checkRange(fit.matrix) || !cv::checkRange(fit.lens)) refuse("the fit fails");
  if (const double tilt_deg = widest_tilt_deg(fit.rotations); !(tilt_deg >= kLeastTilt_deg))
    refuse(fmt::format("the board lies the same way in all, within {:.1f}°", tilt_deg));
  for (int axis = 0; axis < 2; ++axis) {
    const double share = fit.sigmas.at<double>(axis) / fit.matrix(axis, axis);
    if (!(share <= kLargestShare))
      refuse(fmt::format("the focal length is only known to {:.1f} %", 100.0 * share));
  }
}

void refuse_few(std::size_t views) {
  if (views < kFewestViews)
    throw InputError(
        fmt::format("calibrate: a board in {} images, at least {} are needed", views, kFewestViews));
}

/// Throws when the lens cannot be undone where no corner was seen.
void refuse_wild_lens(const features::CameraParameters& camera) try {
  features::CameraModel{camera};
} catch (const std::invalid_argument& fault) {
  throw InputError(std::string("calibrate: ") + fault.what() +
                   "; show the board near the image's corners too");
}

// kdu = Σ (x − x_d)·x_d r_d² / Σ r_d⁶, the least squares of x − x_d (1 + kdu r_d²) over pixels of a grid.
double fitted_kdu(const features::CameraParameters& camera) {
  constexpr int kSteps = 16;
  const features::CameraModel model(camera);
  double product = 0.0, square = 0.0;
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; j <= kSteps; ++j) {
      const features::PixelPoint pixel{i * (camera.width_px - 1.0) / kSteps,
                                       j * (camera.height_px - 1.0) / kSteps};
      const features::NormalizedPoint ray = model.normalize(pixel);
      const double x = (pixel.x - camera.cx_px) / camera.fx_px, y = (pixel.y - camera.cy_px) / camera.fy_px;
      const double r2 = x * x + y * y;
      product += ((ray.x - x) * x + (ray.y - y) * y) * r2;
      square += r2 * r2 * r2;
    }
  }
  return product / square;
}

}  // namespace

Calibration calibrate(const BoardViews& views, const Board& board, cv::Size image_size) {
  refuse_few(views.size());
  const Fit fit = fitted(views, board, image_size, cv::CALIB_FIX_K3);
  refuse_degenerate(fit);
  const Calibration calibration{parameters(fit, image_size), fit.error_px, fit.view_errors_px};
  refuse_wild_lens(calibration.camera);
  return calibration;
}

VispCalibration calibrate_visp(const BoardViews& views, const Board& board, cv::Size image_size) {
  refuse_few(views.size());
  const Fit fit =
      fitted(views, board, image_size, cv::CALIB_ZERO_TANGENT_DIST | cv::CALIB_FIX_K2 | cv::CALIB_FIX_K3);
  refuse_degenerate(fit);
  VispCalibration calibration{parameters(fit, image_size), 0.0, fit.error_px};
  refuse_wild_lens(calibration.camera);
  calibration.kdu = fitted_kdu(calibration.camera);
  return calibration;
}

}  // namespace lineservo::apps
