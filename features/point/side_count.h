#pragma once

#include "features/mask/packed_mask.h"

namespace lineservo::features {

/// Foreground on either side of a line x cosθ + y sinθ = ρ in mask pixels, θ in (−π/2, π/2]. Left is where
/// x cosθ + y sinθ < ρ: left of a vertical line, above a horizontal one. Pixels on the line count nowhere.
struct SideCount {
  int left = 0;
  int right = 0;
};

SideCount count_sides(const PackedMask& mask, double rho_px, double theta_rad);

enum class LTurn { none, left, right };

/// grid §VI-A: at an L all the paint besides the line lies on one side of it, at a node on both; a turn is
/// told when one side has more than `ratio` times the pixels of the other. Throws std::invalid_argument for a
/// ratio below 1.
LTurn l_turn(const SideCount& count, double ratio = 1.5);

}  // namespace lineservo::features
