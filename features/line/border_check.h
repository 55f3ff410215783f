#pragma once

#include <functional>
#include <vector>

#include "features/line/stripe.h"
#include "features/mask/level_mask.h"

namespace lineservo::features {

/// Places along a border of a stripe that have paint on their inner side, spaced evenly.
struct BorderCount {
  int edges = 0;         ///< with bare floor on the outer side
  int paint_beyond = 0;  ///< with paint there as well
  int crossed_edges =
      0;  ///< of both, those within the width of one stripe that may cross, where it hides most
  int crossed_paint = 0;
  int covered = 0;  ///< of paint_beyond, the longest stretch with paint beyond both borders: a disc

  /// Of the first stripe in a frame: whether it is a border, but for one crossing or one disc.
  bool is_border_of_first() const;
  /// The same, stretches aside that lie on stripes which are known, of every further one.
  bool is_border() const;
};

/// Tells a stripe's border from the pieces of border between blotches of worn paint: those have paint beyond
/// them nearly everywhere, a true border only where another stripe crosses and where the stripe meets a disc.
class BorderCheck {
 public:
  /// The part of a stripe's border to look at: between two places of the stripe's axes, on its +1 or −1 side.
  struct Stretch {
    double from = 0.0, to = 0.0, side = 1.0;
  };

  /// `is_known` tells places on stripes that were found before, which say nothing.
  BorderCount count(const LevelMask& mask, const StripeCourse& course, const Stretch& stretch,
                    const std::function<bool(const Eigen::Vector2d&)>& is_known);

 private:
  void find_crossing(std::size_t places, BorderCount& count) const;

  struct Sum {
    int edges = 0, paint_beyond = 0;
  };
  std::vector<Sum> sums_;  ///< up to each place; kept from call to call
};

}  // namespace lineservo::features
