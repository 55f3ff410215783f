#pragma once

#include "servo/law/follow_law.h"

namespace lineservo::servo {

/// Parameters of topology §2.3 and §2.5.
struct PidOptions {
  double kp = 0.5;
  double ki = 0.01;
  double kd = 0.25;
  double integral_limit = 50.0;
  double dead_zone = 0.05;       ///< of the normalised error; inside, the integral is reset
  double half_width_px = 200.0;  ///< c_0: half of the resized frame
};

/// `pid`: the lateral PID of topology on the centroid of the path mask, per call and not per second, as
/// published; it acts while the smoothed code is J2 and leaves the heading alone.
class PidLaw final : public FollowLaw {
 public:
  explicit PidLaw(const PidOptions& options) : options_(options) {}

  void reset() override;
  Command follow(const Observation& observation, const FollowGoal& goal) override;

 private:
  /// PID_out of topology §2.3 for the normalised error e_n (eq. 3); positive to the right.
  double output(double normalized_error);

  PidOptions options_;
  double integral_ = 0.0;
  double previous_error_ = 0.0;
};

}  // namespace lineservo::servo
