#pragma once

#include <optional>
#include <vector>

#include "features/frame_features.h"
#include "features/line/wedge_fit.h"
#include "features/mask/level_mask.h"
#include "features/mask/mask_geometry.h"
#include "features/mask/packed_mask.h"
#include "features/stripe_perception.h"

namespace lineservo::features {

/// A painted line of one picture, in level coordinates.
struct WedgeLine {
  Wedge wedge;
  double begin = 0.0, end = 0.0;  ///< of StripeAxes; end is forward
  double quality = 0.0;           ///< share of its visible border that a straight wedge explains, 0…1
  double evidence = 0.0;          ///< how much it looks painted, 0…1, once it has been judged

  double length() const { return end - begin; }
  LevelPoint at(double along) const {
    const Eigen::Vector2d p = StripeAxes(wedge.course).at(along, 0.0);
    return {p.x(), p.y()};
  }
  double width_at(double along) const {
    return wedge.course.width + wedge.convergence * (along - wedge.at_along);
  }
  /// Between its borders and its ends, with `margin` to spare.
  bool covers(const Eigen::Vector2d& p_L, double margin) const;
};

/// What is seen in one mask.
struct WedgeLines {
  std::vector<WedgeLine> lines;  ///< the best to follow first
  std::optional<JunctionFeature> junction;
  JunctionCode code = JunctionCode::unrecognised;
};

/// Stripes of a single picture, taken by whatever camera: stripes with parallel borders are found first, then
/// each is refined to a wedge, as lines seen at a slant are.
class WedgeLineFinder {
 public:
  explicit WedgeLineFinder(const MaskGeometry& geometry);

  const MaskGeometry& geometry() const { return geometry_; }

  /// Throws std::invalid_argument unless the mask has the size of the geometry.
  WedgeLines find(const PackedMask& mask);

 private:
  WedgeLine refined(const LineFeature& stripe, const LevelMask& mask) const;

  MaskGeometry geometry_;
  StripePerception stripes_;
};

/// The camera that a picture without a camera file is taken to be from: level, without a lens, as wide as the
/// default camera (f = half the width).
MaskGeometry assumed_geometry(int width_px, int height_px);

}  // namespace lineservo::features
