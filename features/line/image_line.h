#pragma once

#include <Eigen/Core>
#include <cmath>
#include <opencv2/core/types.hpp>
#include <optional>
#include <utility>

#include "features/geometry/points.h"

namespace lineservo::features {

/// The centreline of a stripe in an image as given, x cosθ + y sinθ = ρ in pixels. Of a bent stripe it is the
/// tangent at the place nearest to the image centre.
struct ImageLine {
  double rho_px = 0.0;
  double theta_rad = 0.0;                                    ///< in (−π/2, π/2]
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Identity();  ///< of (ρ in pixels, θ in radians)
  double width_px = 0.0;                                     ///< of the stripe; 0: not measured
  double quality = 0.0;                                      ///< 0…1
  double curvature_inv_px = 0.0;  ///< 0 unless significant; positive: bends towards the normal
  PixelPoint begin, end;          ///< of the stripe in view; end is forward, towards −y

  Eigen::Vector2d normal() const { return {std::cos(theta_rad), std::sin(theta_rad)}; }
  Eigen::Vector2d forward() const { return {std::sin(theta_rad), -std::cos(theta_rad)}; }
  double across(const PixelPoint& p) const { return normal().dot(Eigen::Vector2d(p.x, p.y)) - rho_px; }
  PixelPoint at(double along_px) const {
    const Eigen::Vector2d p = rho_px * normal() + along_px * forward();
    return {p.x(), p.y()};
  }
  double along(const PixelPoint& p) const { return forward().dot(Eigen::Vector2d(p.x, p.y)); }
};

/// The same line with θ in (−π/2, π/2]: (ρ, θ) and (−ρ, θ + π) are one line.
ImageLine canonical_line(double rho_px, double theta_rad);

/// The line through two different points.
ImageLine line_through(const PixelPoint& a, const PixelPoint& b);

/// The stretch (along, of ImageLine) of a line within an image, pixels' outer edges included; none if it
/// misses.
std::optional<std::pair<double, double>> stretch_in_image(const ImageLine& line, cv::Size image);

/// How far apart two lines are: |Δρ| and |Δθ|, on whichever branch is the nearer.
struct LineDifference {
  double rho_px = 0.0;     ///< signed, a − b
  double theta_rad = 0.0;  ///< signed, in (−π/2, π/2]
};
LineDifference difference(const ImageLine& a, const ImageLine& b);

/// A line found in an image that was scaled to `from`, in pixels of the image of size `to`. Both sides may
/// scale apart.
ImageLine rescaled(const ImageLine& line, cv::Size from, cv::Size to);

}  // namespace lineservo::features
