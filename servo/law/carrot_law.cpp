#include "servo/law/carrot_law.h"

#include "servo/law/carrot_chase.h"
#include "servo/law/published_followers.h"

namespace lineservo::servo {

// u = κ (ψ_d − ψ) commands the yaw rate   (lfpf Alg. 1, line 11).
Command CarrotLaw::follow(const Observation& observation, const FollowGoal& goal) {
  const auto path = carrot_path(observation);
  if (!path && on_plain_line(observation)) return level_flight(goal);
  const double turn_rad = path ? carrot_turn_rad(*path, options_.delta_px) : 0.0;
  AttitudeCommand command = level_flight(goal);
  command.pitch_rad = features::radians(options_.pitch_deg) * goal.speed_m_s / options_.pitch_speed_m_s +
                      speed_hold(observation, goal.speed_m_s, options_.speed_hold_rad_per_m_s);
  command.yaw_rate_rad_s = options_.kappa_per_s * turn_rad;
  return command;
}

}  // namespace lineservo::servo
