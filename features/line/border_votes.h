#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "features/line/border_points.h"

namespace lineservo::features {

/// What became of a border point while stripes are searched.
enum class PointUse : std::uint8_t {
  free,      ///< may vote for a new stripe
  deferred,  ///< its direction has been tried in this pass
  spent      ///< on the border of a stripe that was found, or inside it
};

/// The direction in which most of the free border runs.
struct DirectionPeak {
  double theta_rad = 0.0;  ///< of the normal, in (−π/2, π/2]
  double length = 0.0;     ///< of border within a few degrees
};

/// The strongest direction among the free points, or none if there is no free point.
std::optional<DirectionPeak> strongest_direction(const std::vector<BorderPoint>& points,
                                                 const std::vector<PointUse>& use);

/// A border seen edge-on: the offset at which many points of one kind lie.
struct OffsetPeak {
  double rho = 0.0;
  double length = 0.0;
};

/// Offsets of the free border points whose normal lies near a direction, apart for the two kinds of border.
class OffsetVotes {
 public:
  static constexpr double kGate_rad = 10.0 * 3.14159265358979323846 / 180.0;

  OffsetVotes(const std::vector<BorderPoint>& points, const std::vector<PointUse>& use, double theta_rad);

  /// Local maxima of at least `min_length` of border and not far below the longest, ordered by offset.
  /// Rising: the paint lies at larger ρ.
  std::vector<OffsetPeak> peaks(bool rising, double min_length) const;

 private:
  static constexpr int kBins = 340;
  static constexpr double kBin = 0.01;
  std::array<std::array<double, kBins>, 2> length_ = {};  ///< falling, rising
};

}  // namespace lineservo::features
