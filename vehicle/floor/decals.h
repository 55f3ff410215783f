#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "vehicle/floor/paint.h"
#include "vehicle/floor/repaint_options.h"
#include "vehicle/floor/wear_options.h"
#include "vehicle/random.h"

namespace lineservo::vehicle {

/// Worn paint, gaps, dirt and objects as shapes like those of the paint, so that they are drawn as exactly.
/// Blotches and spots are Boolean models: Poisson places, each with a radius of its own; the share that they
/// leave uncovered is exp(−λ π E[r²]). The floor is divided into squares that draw their own places, from the
/// seed and their number, when they first come near.
class Decals {
 public:
  /// `layout` must be sound.
  Decals(const Layout& layout, const WearOptions& options, std::uint64_t seed,
         const RepaintOptions& repaint = {});

  bool is_none() const;
  /// Finds what may reach into the disc. It stays until the next call.
  void look_near(const Eigen::Vector2d& p_W, double radius_m);
  /// Holes in the paint of the lines, in the floor's colour, and what was painted over; under the markers.
  const std::vector<const PaintShape*>& holes() const { return holes_; }
  /// What lies on top of everything.
  const std::vector<const PaintShape*>& on_top() const { return on_top_; }

 private:
  using Square = std::pair<int, int>;
  struct Decal {
    PaintShape shape;
    Eigen::Vector2d centre_W;
    double reach_m;  ///< no part of it is further from its centre
  };
  struct Content {
    std::vector<Decal> holes, on_top;
  };

  static Decal disc(const Eigen::Vector2d& centre_W, double radius_m, const Bgr& colour);
  static Decal rectangle(const Eigen::Vector2d& centre_W, double heading_rad, double length_m, double width_m,
                         const Bgr& colour);
  static Decal drawn_object(const Eigen::Vector2d& centre_W, Random& random);
  const Content& content(const Square& square);
  Layout paint_near(const Square& square) const;
  void draw_blotches(const Square& square, const Layout& paint, std::vector<Decal>& holes) const;
  void draw_objects(const Square& square, const Layout& paint, std::vector<Decal>& on_top) const;
  void draw_spots(const Square& square, std::vector<Decal>& on_top) const;
  void cut_gaps();
  void repaint(const RepaintOptions& options);

  Layout layout_;
  WearOptions options_;
  std::uint64_t seed_;
  double blotch_radius_m_;
  std::map<Square, Content> squares_;
  std::vector<Decal> lasting_;  ///< what was painted over or added, then gaps
  std::vector<const PaintShape*> holes_, on_top_;
};

}  // namespace lineservo::vehicle
