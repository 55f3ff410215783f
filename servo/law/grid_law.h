#pragma once

#include <optional>
#include <span>
#include <vector>

#include "features/track/line_tracker.h"
#include "servo/law/follow_law.h"
#include "servo/law/pid_loop.h"

namespace lineservo::servo {

/// Parameters of grid §V. The clips are published; the gains are not (they were tuned by hand), so they are
/// ours, by this argument. Above a line ÿ = −D ẏ + g·φ with the drag D = 0.37/s of the vehicle: K_p = ω²/g
/// and K_d = (2ζω − D)/g put the poles at ω = 1/s, ζ = 0.8, a quarter of what a delay of 0.25 s (camera,
/// frame, attitude) would allow, and K_i = K_p/10 s takes out a tilt bias well below ω. The heading needs K_p
/// alone.
struct GridOptions {
  PidGains roll = {0.102, 0.01, 0.125};   ///< rad per m, per m s, per m/s across the vertical line
  PidGains pitch = {0.102, 0.01, 0.125};  ///< the same along it
  PidGains yaw = {1.0, 0.0, 0.0};         ///< rad/s per rad
  double tilt_limit_deg = 1.0;
  double yaw_rate_limit_deg_s = 1.0;
  double trim_rad_per_m_s = 0.038;  ///< D/g: what the imaginary line ahead comes to, against the drag
};

/// `grid`: PID loops on roll, pitch and yaw rate from the Kalman-filtered (ρ, θ) of a vertical and a
/// horizontal line, clipped. On the way an imaginary horizontal line leads; above the goal node the real one
/// holds.
class GridLaw final : public FollowLaw {
 public:
  explicit GridLaw(const GridOptions& options) : options_(options) {}

  void reset() override { *this = GridLaw(options_); }
  Command follow(const Observation& observation, const FollowGoal& goal) override;
  std::optional<Command> hover(const Observation& observation, const FollowGoal& goal) override;

 private:
  /// Metres off a tracked line, to the right or backward, and its angle.
  struct Line {
    double offset_m;
    double theta_rad;
  };
  double step_s(const Observation& observation);
  std::optional<Line> vertical(const Observation& observation, double dt_s);
  std::optional<Line> horizontal(const Observation& observation, double dt_s);
  /// Roll and yaw rate from the vertical line, or level.
  AttitudeCommand beside(const std::optional<Line>& line, double dt_s, const FollowGoal& goal);
  double speed_pitch(const Observation& observation, double speed_m_s) const;
  double tilt_limit_rad() const;

  GridOptions options_;
  features::LineTracker vertical_, horizontal_;
  PidLoop roll_, pitch_, yaw_;
  std::optional<Time> last_captured_;
};

/// The line as seen by a camera turned by 90° clockwise: a horizontal line becomes a vertical one, and what
/// lay below the centre lies to its right.
features::LineFeature quarter_turned(features::LineFeature line);

}  // namespace lineservo::servo
