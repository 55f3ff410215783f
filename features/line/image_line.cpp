#include "features/line/image_line.h"

#include <algorithm>
#include <limits>

#include "features/geometry/angles.h"

namespace lineservo::features {

ImageLine canonical_line(double rho_px, double theta_rad) {
  ImageLine line;
  line.theta_rad = wrap_angle(theta_rad);
  line.rho_px = rho_px;
  if (line.theta_rad > kPi / 2.0 || line.theta_rad <= -kPi / 2.0) {
    line.theta_rad = wrap_angle(line.theta_rad + kPi);
    line.rho_px = -line.rho_px;
  }
  return line;
}

ImageLine line_through(const PixelPoint& a, const PixelPoint& b) {
  const double theta_rad = std::atan2(b.x - a.x, a.y - b.y);  // of the normal (a.y − b.y, b.x − a.x)
  ImageLine line = canonical_line(a.x * std::cos(theta_rad) + a.y * std::sin(theta_rad), theta_rad);
  const bool ahead = line.along(b) >= line.along(a);
  line.begin = ahead ? a : b;
  line.end = ahead ? b : a;
  return line;
}

std::optional<std::pair<double, double>> stretch_in_image(const ImageLine& line, cv::Size image) {
  const Eigen::Vector2d foot = line.rho_px * line.normal(), step = line.forward();
  const Eigen::Vector2d high(image.width - 0.5, image.height - 0.5);
  double from = -std::numeric_limits<double>::infinity(), to = -from;
  for (int axis = 0; axis < 2; ++axis) {
    if (std::abs(step[axis]) < 1e-12) {
      if (foot[axis] < -0.5 || foot[axis] > high[axis]) return std::nullopt;
      continue;
    }
    const double a = (-0.5 - foot[axis]) / step[axis], b = (high[axis] - foot[axis]) / step[axis];
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
  if (from >= to) return std::nullopt;
  return std::pair{from, to};
}

LineDifference difference(const ImageLine& a, const ImageLine& b) {
  const double turn = wrap_angle(a.theta_rad - b.theta_rad);
  if (turn > -kPi / 2.0 && turn <= kPi / 2.0) return {a.rho_px - b.rho_px, turn};
  return {-a.rho_px - b.rho_px, wrap_angle(turn + kPi)};
}

namespace {

struct Scaling {
  double x, y;
  PixelPoint apply(const PixelPoint& p) const { return {(p.x + 0.5) * x - 0.5, (p.y + 0.5) * y - 0.5}; }
};

// x cosθ + y sinθ = ρ with x = (x' + ½)/s_x − ½: n' = (cosθ/s_x, sinθ/s_y), ρ' = ρ + ½(cosθ + sinθ) −
// ½(n'_x + n'_y), both over |n'|.
ImageLine scaled_equation(const ImageLine& line, const Scaling& scale) {
  const Eigen::Vector2d n = line.normal();
  const Eigen::Vector2d m(n.x() / scale.x, n.y() / scale.y);
  return canonical_line((line.rho_px + 0.5 * (n.sum() - m.sum())) / m.norm(), std::atan2(m.y(), m.x()));
}

// ∂(ρ', θ')/∂(ρ, θ) by central differences.
Eigen::Matrix2d scaling_jacobian(const ImageLine& line, const Scaling& scale) {
  Eigen::Matrix2d J;
  constexpr double step[2] = {0.5, 1e-4};
  for (int k = 0; k < 2; ++k) {
    ImageLine low = line, high = line;
    (k == 0 ? low.rho_px : low.theta_rad) -= step[k];
    (k == 0 ? high.rho_px : high.theta_rad) += step[k];
    const LineDifference d = difference(scaled_equation(high, scale), scaled_equation(low, scale));
    J(0, k) = d.rho_px / (2.0 * step[k]);
    J(1, k) = d.theta_rad / (2.0 * step[k]);
  }
  return J;
}

}  // namespace

ImageLine rescaled(const ImageLine& line, cv::Size from, cv::Size to) {
  if (from == to) return line;
  const Scaling scale{static_cast<double>(to.width) / from.width,
                      static_cast<double>(to.height) / from.height};
  ImageLine image = scaled_equation(line, scale);
  const Eigen::Matrix2d J = scaling_jacobian(line, scale);
  image.covariance = J * line.covariance * J.transpose();
  const Eigen::Vector2d n = line.normal();
  image.width_px = line.width_px / std::hypot(n.x() / scale.x, n.y() / scale.y);
  image.quality = line.quality;
  image.curvature_inv_px = line.curvature_inv_px / std::sqrt(scale.x * scale.y);
  image.begin = scale.apply(line.begin);
  image.end = scale.apply(line.end);
  if (image.along(image.begin) > image.along(image.end)) std::swap(image.begin, image.end);
  return image;
}

}  // namespace lineservo::features
