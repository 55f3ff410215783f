#pragma once

#include <optional>

#include "servo/law/drift_observer.h"
#include "servo/law/follow_law.h"
#include "servo/task/sideways_task.h"

namespace lineservo::servo {

/// Which point of the path is servoed on.
enum class PathPoint {
  centroid,  ///< of the path's mask (topology §2.3)
  target,    ///< the virtual target point (vtp §3.1)
};

/// Parameters of `ibvs-centroid` and `ibvs-point`.
struct IbvsPointOptions {
  AdaptiveGain gain = {2.0, 0.9, 2.0};
  double drift_time_constant_s = 0.4;
  /// Of the drift that a junction is passed with, which takes seconds: as long, or the pull of an arm that
  /// just comes into view would be carried on as a drift.
  double junction_drift_time_constant_s = 2.0;
  double drift_limit_m_s = 0.3;
  double coast_s = 0.5;      ///< how long a point that was lost is followed by odometry
  double view_margin = 0.6;  ///< |x| at which the forward speed is nil, normalised units
};

/// `ibvs-centroid` and `ibvs-point`: visual servoing on one point of the path in the virtual level camera,
/// brought to x = 0, with the height by its own task and the forward speed in the null space. The heading is
/// the executive's.
///
/// Both points are pulled aside by the arms of a junction, so a frame counts only when its code, raw and
/// smoothed, is that of a plain line and no other stripe is in view. In between the vehicle goes on by
/// odometry, and then straight ahead with the drift that was learnt.
class IbvsPointLaw final : public FollowLaw {
 public:
  IbvsPointLaw(PathPoint which, const IbvsPointOptions& options);

  void reset() override;
  Command follow(const Observation& observation, const FollowGoal& goal) override;

 private:
  /// The point in this frame, or none that can be trusted.
  const features::LevelPoint* usable_point(const Observation& observation) const;
  void observe_drift(const Observation& observation, const Eigen::Vector2d& point_m);
  /// As learnt in this frame or, when it does not count, over a longer time.
  double drift_m_s(const Observation& observation) const;
  /// The point as it is now: measured and moved on by odometry and drift, or coasted.
  std::optional<features::LevelPoint> point_now(const Observation& observation);

  PathPoint which_;
  IbvsPointOptions options_;
  SidewaysTask task_;
  DriftObserver drift_, junction_drift_;
  struct Sighting {
    Eigen::Vector2d point_m;  ///< heading frame of the capture
    Time captured;
    Motion odometry;
  };
  std::optional<Sighting> last_;
};

}  // namespace lineservo::servo
