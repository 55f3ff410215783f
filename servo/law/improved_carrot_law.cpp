#include "servo/law/improved_carrot_law.h"

#include <algorithm>
#include <cmath>

#include "servo/law/carrot_chase.h"
#include "servo/law/published_followers.h"

namespace lineservo::servo {

using features::radians;

// Alg. 2 as printed, roll = c_1·pitch·(e^{sin u} − 1) and pitch = c_2·pitch·(1 − cos u), is recursive and
// stands still at u = 0. The text says what is meant: the more it turns, the more roll (centripetal force)
// and the less pitch. With `pitch` on the right-hand side in degrees, c_1 gives thousandths of a degree at
// most; as the pitch channel of an ArduPilot remote, 1500 µs in the middle and within a few per cent of it in
// flight, both constants make sense in degrees:
//   roll  = 1.95° (e^{sin u} − 1)       0.8°, the centripetal force on the bend of §3.3.4, at u = 20°
//   pitch = 1° − 24° (1 − cos u)        no less than 0, which is reached at u = 17°
// Both in proportion to the speed: "pitch refers to the velocity".
Command ImprovedCarrotLaw::follow(const Observation& observation, const FollowGoal& goal) {
  const auto path = carrot_path(observation);
  if (!path && on_plain_line(observation)) return level_flight(goal);
  const double turn_rad = path ? carrot_turn_rad(*path, options_.delta_px) : 0.0;
  const double share = pitch_share(turn_rad);
  const double scale = goal.speed_m_s / options_.pitch_speed_m_s;
  AttitudeCommand command = level_flight(goal);
  command.roll_rad = scale * roll_rad(turn_rad);
  command.pitch_rad = scale * share * radians(options_.pitch_deg) +
                      speed_hold(observation, share * goal.speed_m_s, options_.speed_hold_rad_per_m_s);
  command.yaw_rate_rad_s = options_.kappa_per_s * turn_rad;
  return command;
}

// u as an image has it, clockwise positive: e^{sin u} − 1 is larger to the right than to the left, as
// printed.
double ImprovedCarrotLaw::roll_rad(double turn_rad) const {
  return radians(options_.c1 * options_.channel_us) * std::expm1(std::sin(-turn_rad));
}

double ImprovedCarrotLaw::pitch_share(double turn_rad) const {
  const double taken_deg = options_.c2 * options_.channel_us * (1.0 - std::cos(turn_rad));
  return std::clamp(1.0 - taken_deg / options_.pitch_deg, 0.0, 1.0);
}

}  // namespace lineservo::servo
