#pragma once

#include <optional>

#include "servo/law/drift_observer.h"
#include "servo/law/follow_law.h"
#include "servo/task/line_task.h"

namespace lineservo::servo {

/// Parameters of `ibvs`, of the settings servo.ibvs.*.
struct IbvsLineOptions {
  AdaptiveGain gain = {2.0, 0.9, 2.0};
  InteractionMatrix interaction = InteractionMatrix::current;
  double drift_time_constant_s = 0.25;
  double drift_limit_m_s = 0.3;
  double coast_s = 0.5;                 ///< how long a line that was lost is followed by odometry
  double view_margin = 0.6;             ///< |ρ| at which the forward speed is nil, normalised units
  double view_angle_rad = 0.6;          ///< |θ| at which it is nil
  double bend_acceleration_m_s2 = 0.5;  ///< across the line, in a bend: v ≤ √(a·R)
  double bend_yaw_rate_rad_s = 0.8;     ///< in a bend: v ≤ ω·R
};

/// `ibvs`: image-based visual servoing on the fitted line (ρ, θ) in the virtual level camera, the forward
/// speed in the null space of the line task, the height by its own task, and the sideways drift fed forward.
class IbvsLineLaw final : public FollowLaw {
 public:
  explicit IbvsLineLaw(const IbvsLineOptions& options);

  void reset() override;
  Command follow(const Observation& observation, const FollowGoal& goal) override;

 private:
  void observe_drift(const Observation& observation, const features::LineFeature& line);
  /// The line as it is now: measured and moved on by odometry, or coasted.
  std::optional<features::LineFeature> line_now(const Observation& observation);
  double safe_speed(const features::LineFeature& line, double height_m, double speed_m_s) const;

  IbvsLineOptions options_;
  LineTask task_;
  DriftObserver drift_;
  struct Sighting {
    features::LineFeature line;
    Time captured;
    Motion odometry;
    double height_m;
  };
  std::optional<Sighting> last_;
};

}  // namespace lineservo::servo
