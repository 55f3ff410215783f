#pragma once

namespace lineservo::vehicle {

/// What use does to a painted floor. All of it lies still on the floor: the seed and the place decide.
struct WearOptions {
  /// Of the paint missing in round blotches: a sixth of the narrowest line's width in radius, within 12.5 to
  /// 30 mm, each give or take a half of that.
  double worn_share = 0.0;      ///< 0 … 0.9
  double gap_m = 0.0;           ///< length of gaps across a line; 0 … 1, none at 0
  double gap_every_m = 3.0;     ///< one in each stretch of a line this long, clear of the nodes; 0.2 … 1000
  double dirt_share = 0.0;      ///< of floor and paint under dark spots; 0 … 0.5
  double objects_per_m2 = 0.0;  ///< boxes and pieces of tape in other colours, beside the lines; 0 … 20

  /// Throws std::invalid_argument that names what is out of bounds.
  void validate() const;
};

}  // namespace lineservo::vehicle
