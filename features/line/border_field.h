#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "features/geometry/angles.h"
#include "features/line/border_points.h"

namespace lineservo::features {

/// What became of a border point while stripes are searched.
enum class PointUse : std::uint8_t {
  free,      ///< may vote for a new stripe
  deferred,  ///< its direction has been tried in this pass
  spent      ///< on the border of a stripe that was found, or inside it; the last one
};

/// The direction in which most of the free border runs.
struct DirectionPeak {
  double theta_rad = 0.0;  ///< of the normal, in (−π/2, π/2]
  double length = 0.0;     ///< of border within a few degrees
};

/// The border points of a frame, ordered by direction, and what became of each. Worn paint has thousands of
/// points that look every way; a stripe has to do with those that look its own.
class BorderField {
 public:
  static constexpr int kDirections = 180;                    ///< bins of 1° over half a turn
  static constexpr double kWidest_rad = 30.0 * kPi / 180.0;  ///< that near() gives

  /// Takes over the points of a frame, all of them free.
  void assign(const std::vector<BorderPoint>& points);

  std::size_t size() const { return use_.size(); }
  const BorderPoint& at(std::size_t i) const { return points_[i]; }
  PointUse use(std::size_t i) const { return use_[i]; }
  void set_use(std::size_t i, PointUse use) {
    is_stale_[bins_[i]] |= use_[i] != use;
    use_[i] = use;
  }
  /// The same without a branch, where it is too wild to be predicted: nothing happens unless `spends`.
  void spend_if(std::size_t i, bool spends) {
    const int use = static_cast<int>(use_[i]), wanted = static_cast<int>(PointUse::spent) * int{spends};
    set_use(i, static_cast<PointUse>(std::max(use, wanted)));
  }
  /// Deferred points are free again.
  void release_deferred();

  /// All points whose axis lies within an angle of at most kWidest_rad of a direction (modulo π), and few
  /// others, in an order that does not depend on the angle.
  std::span<const BorderPoint> near(double theta_rad, double within_rad = kWidest_rad) const;
  /// The number of a point of near().
  std::size_t number(const BorderPoint& point) const {
    const auto place = static_cast<std::size_t>(&point - points_.data());
    return place < use_.size() ? place : place - use_.size();
  }

  /// The strongest direction among the free points, or none if there is no free point.
  std::optional<DirectionPeak> strongest_direction();

 private:
  std::size_t first_of(int bin) const;
  void measure_bins();

  std::vector<BorderPoint> points_;  ///< ordered by bin; those of the first bins once more at the end
  std::vector<PointUse> use_;
  std::vector<std::uint8_t> bins_;
  std::array<std::uint32_t, kDirections + 1> first_ = {};  ///< of each bin
  std::array<double, kDirections> free_length_ = {};       ///< of each bin
  std::array<bool, kDirections> is_stale_ = {};            ///< its free length
};

}  // namespace lineservo::features
