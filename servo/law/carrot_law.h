#pragma once

#include "servo/law/follow_law.h"

namespace lineservo::servo {

/// Parameters of lfpf Alg. 1. The paper prints no κ and no pitch of its own for it.
struct CarrotOptions {
  double delta_px = 100.0;
  /// κ. With the drag D of the body the loop from the carrot to the place is stable while
  /// κ + D > v / (δ h / f): 3 keeps it so at 0.46 m/s, the speed that lfpf flew, and far below what the
  /// camera's delay allows.
  double kappa_per_s = 3.0;
  double pitch_deg = 1.0;               ///< as flown with the improved law (lfpf §4.1.1), forward
  double pitch_speed_m_s = 0.46;        ///< what that pitch comes to against the drag
  double speed_hold_rad_per_m_s = 0.1;  ///< ours; 0: the paper alone
};

/// `carrot`: turns towards a point ahead on the line, at a constant pitch, without roll.
class CarrotLaw final : public FollowLaw {
 public:
  explicit CarrotLaw(const CarrotOptions& options) : options_(options) {}

  void reset() override {}  // it remembers nothing
  Command follow(const Observation& observation, const FollowGoal& goal) override;

 private:
  CarrotOptions options_;
};

}  // namespace lineservo::servo
