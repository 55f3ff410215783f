#pragma once

#include <array>
#include <vector>

#include "features/line/border_field.h"

namespace lineservo::features {

/// A border seen edge-on: the offset at which many points of one kind lie.
struct OffsetPeak {
  double rho = 0.0;
  double length = 0.0;
};

/// Offsets of the free border points whose normal lies near a direction, apart for the two kinds of border.
class OffsetVotes {
 public:
  static constexpr double kGate_rad = 10.0 * 3.14159265358979323846 / 180.0;

  OffsetVotes(const BorderField& border, double theta_rad);

  /// Local maxima of at least `min_length` of border and not far below the longest, ordered by offset.
  /// Rising: the paint lies at larger ρ.
  std::vector<OffsetPeak> peaks(bool rising, double min_length) const;

 private:
  static constexpr int kBins = 340;
  static constexpr double kBin = 0.01;
  std::array<std::array<double, kBins>, 2> length_ = {};  ///< falling, rising
  std::size_t first_ = kBins, last_ = 0;                  ///< bins that hold any
};

}  // namespace lineservo::features
