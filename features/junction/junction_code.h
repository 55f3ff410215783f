#pragma once

#include <string_view>

namespace lineservo::features {

/// Junction codes of topology Fig. 3. Up in the image is forward.
enum class JunctionCode {
  start = 0,         ///< J0: the red start marker is in view
  unrecognised = 1,  ///< J1
  straight = 2,      ///< J2
  cross = 3,         ///< J3 ┼
  corner_right = 4,  ///< J4: ┌ ahead, └ behind
  corner_left = 5,   ///< J5: ┐ ahead, ┘ behind
  tee_behind = 6,    ///< J6 ┴: a cross or T being left behind
  tee_ahead = 7,     ///< J7 ┬: a cross or T coming up
  tee_right = 8,     ///< J8 ├
  tee_left = 9,      ///< J9 ┤
};

inline constexpr int kJunctionCodes = 10;

/// "J0" … "J9".
std::string_view name(JunctionCode code);

/// Which arms of a node are in view; forward is up in the image.
struct Arms {
  bool forward = false;
  bool back = false;
  bool left = false;
  bool right = false;

  friend bool operator==(const Arms&, const Arms&) = default;
};

/// The code of a set of visible arms: the table of codes.md {F,B,L,R} → J3 … {L,R} or nothing → J1; one arm →
/// J2.
JunctionCode code_of(const Arms& arms);

}  // namespace lineservo::features
