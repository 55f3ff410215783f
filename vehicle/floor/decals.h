#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "vehicle/floor/paint.h"

namespace lineservo::vehicle {

/// What use does to a painted floor. All of it lies still on the floor: the seed and the place decide.
struct WearOptions {
  /// Of the paint missing in round blotches (a fifth of the narrowest line's width in radius, 20 mm at
  /// least).
  double worn_share = 0.0;      ///< 0 … 0.9
  double gap_m = 0.0;           ///< length of gaps across a line; 0 … 1, none at 0
  double gap_every_m = 3.0;     ///< one in each stretch of a line this long, clear of the nodes; 0.2 … 1000
  double dirt_share = 0.0;      ///< of floor and paint under dark spots; 0 … 0.5
  double objects_per_m2 = 0.0;  ///< boxes and pieces of tape in other colours, beside the lines; 0 … 20

  /// Throws std::invalid_argument that names what is out of bounds.
  void validate() const;
};

/// Worn paint, gaps, dirt and objects as shapes like those of the paint, so that they are drawn as exactly.
/// Blotches and spots are Boolean models: Poisson places, each with a radius of its own; the share that they
/// leave uncovered is exp(−λ π E[r²]). The floor is divided into squares that draw their own places, from the
/// seed and their number, when they first come near.
class Decals {
 public:
  /// `layout` must be sound.
  Decals(const Layout& layout, const WearOptions& options, std::uint64_t seed);

  bool is_none() const;
  /// Finds what may reach into the disc. It stays until the next call.
  void look_near(const Eigen::Vector2d& p_W, double radius_m);
  /// Holes in the paint of the lines, in the floor's colour; under the markers.
  const std::vector<const PaintShape*>& holes() const { return holes_; }
  /// What lies on top of everything.
  const std::vector<const PaintShape*>& on_top() const { return on_top_; }

 private:
  using Square = std::pair<int, int>;
  struct Content {
    std::vector<PaintShape> holes, on_top;
  };

  const Content& content(const Square& square);
  void draw_blotches(const Square& square, std::vector<PaintShape>& holes) const;
  void draw_objects(const Square& square, std::vector<PaintShape>& on_top) const;
  void draw_spots(const Square& square, std::vector<PaintShape>& on_top) const;
  void cut_gaps();

  Layout layout_;
  WearOptions options_;
  std::uint64_t seed_;
  double blotch_radius_m_;
  std::map<Square, Content> squares_;
  std::vector<PaintShape> gaps_;
  std::vector<Eigen::Vector2d> gap_centres_W_;
  std::vector<const PaintShape*> holes_, on_top_;
};

}  // namespace lineservo::vehicle
