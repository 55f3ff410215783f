#include "features/point/side_count.h"

#include <cmath>
#include <stdexcept>

namespace lineservo::features {

SideCount count_sides(const PackedMask& mask, double rho_px, double theta_rad) {
  const double c = std::cos(theta_rad), s = std::sin(theta_rad);
  SideCount count;
  for (int y = 0; y < mask.height(); ++y) {
    for (int x = 0; x < mask.width(); ++x) {
      if (!mask.at(x, y)) continue;
      const double offset_px = x * c + y * s - rho_px;
      count.left += int{offset_px < 0.0};
      count.right += int{offset_px > 0.0};
    }
  }
  return count;
}

LTurn l_turn(const SideCount& count, double ratio) {
  if (!(ratio >= 1.0)) throw std::invalid_argument("L-turn: the ratio must be at least 1");
  if (count.left > ratio * count.right) return LTurn::left;
  if (count.right > ratio * count.left) return LTurn::right;
  return LTurn::none;
}

}  // namespace lineservo::features
