#pragma once

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <vector>

#include "features/line/image_line.h"
#include "features/mask/packed_mask.h"
#include "tests/features/test_masks.h"

/// Pictures of stripes that are exact to the rounding of their pixels. For tests alone.
namespace lineservo::features::test {

/// A stripe in an image: centreline x cosθ + y sinθ = ρ and a width.
struct DrawnStripe {
  double rho_px = 0.0, theta_rad = 0.0, width_px = 0.0;
};

/// The area of a pixel in which n·p ≤ c, for a distance d = c − n·centre: the second integral of a step over
/// both sides of the square.
inline double half_plane_coverage(double d, double nx, double ny) {
  const double a = std::max(std::abs(nx), std::abs(ny)), b = std::min(std::abs(nx), std::abs(ny));
  if (b < 1e-7) return std::clamp(d / a + 0.5, 0.0, 1.0);
  const auto ramp = [](double x) { return x > 0.0 ? 0.5 * x * x : 0.0; };
  const double p = 0.5 * (a + b), q = 0.5 * (a - b);
  return (ramp(d + p) - ramp(d + q) - ramp(d - q) + ramp(d - p)) / (a * b);
}

inline double coverage(const DrawnStripe& stripe, int x, int y) {
  const double nx = std::cos(stripe.theta_rad), ny = std::sin(stripe.theta_rad);
  const double d = stripe.rho_px - nx * x - ny * y;
  return half_plane_coverage(d + 0.5 * stripe.width_px, nx, ny) -
         half_plane_coverage(d - 0.5 * stripe.width_px, nx, ny);
}

/// Yellow on grey, BGR.
inline cv::Mat draw_image(cv::Size size, const std::vector<DrawnStripe>& stripes) {
  cv::Mat image(size, CV_8UC3);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      double bare = 1.0;
      for (const DrawnStripe& stripe : stripes) bare *= 1.0 - coverage(stripe, x, y);
      const cv::Vec3d colour = bare * cv::Vec3d(120, 122, 118) + (1.0 - bare) * cv::Vec3d(10, 200, 230);
      image.at<cv::Vec3b>(y, x) = {cv::saturate_cast<std::uint8_t>(colour[0]),
                                   cv::saturate_cast<std::uint8_t>(colour[1]),
                                   cv::saturate_cast<std::uint8_t>(colour[2])};
    }
  }
  return image;
}

inline PackedMask draw_mask(cv::Size size, const std::vector<DrawnStripe>& stripes) {
  PackedMask mask(size.width, size.height);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x)
      for (const DrawnStripe& stripe : stripes)
        if (coverage(stripe, x, y) >= 0.5) mask.set(x, y);
  return mask;
}

/// The paint of a picture as draw_image() and its like make it: what is more red than blue by 60.
inline PackedMask yellow_mask(const cv::Mat& image) {
  PackedMask mask(image.cols, image.rows);
  for (int y = 0; y < image.rows; ++y)
    for (int x = 0; x < image.cols; ++x) {
      const cv::Vec3b& p = image.at<cv::Vec3b>(y, x);
      if (p[2] > p[0] + 60) mask.set(x, y);
    }
  return mask;
}

inline ImageLine centreline(const DrawnStripe& stripe) {
  return canonical_line(stripe.rho_px, stripe.theta_rad);
}

/// A stripe of some width through a point of the image, normal at an angle.
inline DrawnStripe stripe_through(double x, double y, double theta_deg, double width_px) {
  const double theta_rad = radians(theta_deg);
  return {x * std::cos(theta_rad) + y * std::sin(theta_rad), theta_rad, width_px};
}

}  // namespace lineservo::features::test
