#pragma once

#include <Eigen/Core>
#include <cmath>

#include "features/frame_features.h"

namespace lineservo::features {

/// The course of a stripe: a centreline of direction θ at offset ρ, and a width; all normalised, in L.
struct StripeCourse {
  double theta_rad = 0.0;
  double rho = 0.0;
  double width = 0.0;

  Eigen::Vector2d normal() const { return {std::cos(theta_rad), std::sin(theta_rad)}; }
  /// Unit, forward for θ in (−π/2, π/2).
  Eigen::Vector2d forward() const { return {std::sin(theta_rad), -std::cos(theta_rad)}; }
};

/// The coordinates of a stripe: `across` from its centreline towards the normal, and `along` it, forward,
/// from the foot of the origin.
class StripeAxes {
 public:
  explicit StripeAxes(const StripeCourse& course)
      : normal_(course.normal()),
        forward_(course.forward()),
        foot_(course.rho * normal_),
        width_(course.width) {}

  const Eigen::Vector2d& normal() const { return normal_; }
  const Eigen::Vector2d& forward() const { return forward_; }
  double width() const { return width_; }
  Eigen::Vector2d at(double along, double across) const {
    return foot_ + along * forward_ + across * normal_;
  }
  double along(const Eigen::Vector2d& p_L) const { return p_L.dot(forward_); }
  double across(const Eigen::Vector2d& p_L) const { return (p_L - foot_).dot(normal_); }

 private:
  Eigen::Vector2d normal_, forward_, foot_;
  double width_;
};

/// How one end of a stripe looks.
struct StripeEnd {
  double along = 0.0;       ///< of StripeAxes
  bool leaves_view = true;  ///< the paint goes on to the edge of the image
  double bare = 0.0;        ///< length in view beyond the end that is bare floor
};

/// A stripe as found: the feature for the laws, and what the junction needs to know besides.
struct Stripe {
  StripeCourse course;
  LineFeature feature;
  StripeEnd begin, end;  ///< end is forward
  bool both_borders = true;
};

/// What is known beforehand of the stripe that is followed, from the prediction.
struct StripePrior {
  double rho = 0.0;
  double theta_rad = 0.0;
  double width = 0.0;  ///< 0: unknown
};

}  // namespace lineservo::features
