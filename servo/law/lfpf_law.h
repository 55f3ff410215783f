#pragma once

#include "servo/law/follow_law.h"

namespace lineservo::servo {

/// Parameters of lfpf Alg. 3 and Table 3 (simulation).
struct LfpfOptions {
  double c1_deg = 1.2;
  double c2_deg = 0.01;
  double b_deg = 0.14;
  double sigmoid_px = 80.0;
  /// The speed that the printed pitch c_2 + b belongs to: −0.19° was flown, about 0.09 m/s, 0.15° is printed.
  double pitch_speed_m_s = 0.071;
  double yaw_gain_per_s = 1.0;          ///< ours: the paper commands an angle
  double speed_hold_rad_per_m_s = 0.1;  ///< ours; 0: the paper alone
};

/// `lfpf`: roll from the sideways offset of the fitted line's midpoint through a sigmoid, yaw from its slope,
/// a pitch that hardly changes. Without a line it keeps level.
class LfpfLaw final : public FollowLaw {
 public:
  explicit LfpfLaw(const LfpfOptions& options) : options_(options) {}

  void reset() override {}  // it remembers nothing
  Command follow(const Observation& observation, const FollowGoal& goal) override;

 private:
  double roll_rad(const features::LineFeature& line) const;
  double pitch_rad(const features::LineFeature& line, double speed_m_s) const;

  LfpfOptions options_;
};

}  // namespace lineservo::servo
