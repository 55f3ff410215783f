#include "features/junction/junction_code.h"

#include <array>

namespace lineservo::features {

std::string_view name(JunctionCode code) {
  static constexpr std::array<std::string_view, kJunctionCodes> kNames = {"J0", "J1", "J2", "J3", "J4",
                                                                          "J5", "J6", "J7", "J8", "J9"};
  return kNames[static_cast<std::size_t>(code)];
}

JunctionCode code_of(const Arms& arms) {
  const int along = int{arms.forward} + int{arms.back};
  if (arms.left && arms.right) {
    if (along == 2) return JunctionCode::cross;
    if (along == 0) return JunctionCode::unrecognised;
    return arms.back ? JunctionCode::tee_ahead : JunctionCode::tee_behind;
  }
  if (arms.left || arms.right) {
    if (along == 0) return JunctionCode::straight;
    if (along == 2) return arms.left ? JunctionCode::tee_left : JunctionCode::tee_right;
    return arms.left ? JunctionCode::corner_left : JunctionCode::corner_right;
  }
  return along == 0 ? JunctionCode::unrecognised : JunctionCode::straight;
}

}  // namespace lineservo::features
