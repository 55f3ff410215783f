#pragma once

#include "servo/law/follow_law.h"

namespace lineservo::servo {

/// Parameters of lfpf Alg. 2 and Table 3.
struct ImprovedCarrotOptions {
  double c1 = 0.0013;  ///< degrees of roll for a microsecond of the pitch channel
  double c2 = 0.016;   ///< degrees of pitch for the same
  double delta_px = 100.0;
  double channel_us = 1500.0;           ///< `pitch` on the right of the printed formulas, see the law
  double kappa_per_s = 3.0;             ///< as for `carrot`
  double pitch_deg = 1.0;               ///< as flown (§4.1.1), forward
  double pitch_speed_m_s = 0.46;        ///< what that pitch comes to against the drag
  double speed_hold_rad_per_m_s = 0.1;  ///< ours; 0: the paper alone
};

/// `improved-carrot`: the carrot's turn, with roll for the centripetal force and less pitch the more it
/// turns.
class ImprovedCarrotLaw final : public FollowLaw {
 public:
  explicit ImprovedCarrotLaw(const ImprovedCarrotOptions& options) : options_(options) {}

  void reset() override {}  // it remembers nothing
  Command follow(const Observation& observation, const FollowGoal& goal) override;

 private:
  double roll_rad(double turn_rad) const;
  /// What is left of the pitch in a turn, 0…1.
  double pitch_share(double turn_rad) const;

  ImprovedCarrotOptions options_;
};

}  // namespace lineservo::servo
