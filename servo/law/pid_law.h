#pragma once

#include <optional>

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
  // Yaw on curves (§2.4, eq. 4–6).
  double yaw_gamma_px_m = 45.0;  ///< Γ: yaws while the offset is above Γ / 2h, 45 px at 0.5 m
  double yaw_clip_px = 55.0;     ///< of the offset, from the published code
  /// f. As printed the offset is of the resized frame and f of the raw one; 200 would be of the same frame.
  double yaw_focal_px = 320.0;
  double yaw_rate_limit_rad_s = 0.6;  ///< ours: the paper's autopilot turns at a rate of its own
};

/// `pid`: the lateral PID of topology on the centroid of the path mask, per call and not per second, as
/// published; it acts while the smoothed code is J2 and leaves the heading alone. On an edge that bends it
/// yaws as well, by the angle of the centroid's offset while that is large.
class PidLaw final : public FollowLaw {
 public:
  explicit PidLaw(const PidOptions& options) : options_(options) {}

  void reset() override;
  Command follow(const Observation& observation, const FollowGoal& goal) override;

 private:
  /// PID_out of topology §2.3 for the normalised error e_n (eq. 3); positive to the right.
  double output(double normalized_error);

  /// Rate that turns by ψ of eq. 6 within the time from frame to frame.
  double yaw_rate_rad_s(double offset_px, const Observation& observation) const;

  PidOptions options_;
  double integral_ = 0.0;
  double previous_error_ = 0.0;
  std::optional<Time> captured_;  ///< of the frame before
};

}  // namespace lineservo::servo
