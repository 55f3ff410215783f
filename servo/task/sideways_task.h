#pragma once

#include <memory>

#include "features/geometry/points.h"
#include "servo/task/visual_task.h"

namespace lineservo::servo {

/// What is known of the vehicle's motion when a task is solved.
struct KnownMotion {
  double forward_m_s = 0.0;     ///< asked for, into the null space
  double yaw_rate_rad_s = 0.0;  ///< commanded by someone else at the same time
  double drift_m_s = 0.0;       ///< to the left, which the vehicle does not know of
};

/// Task of rank 2: a point of the path straight ahead or below (vpFeaturePoint, x alone) at a height
/// (vpFeatureDepth). The yaw is not its own: what it does to the point is fed forward. The null space is the
/// forward speed.
class SidewaysTask {
 public:
  explicit SidewaysTask(const AdaptiveGain& gain);
  ~SidewaysTask();

  /// `point`: the point as it is now.
  TaskSolution solve(features::LevelPoint point, double height_m, double desired_height_m,
                     const KnownMotion& motion);

  const VisualTask& task() const { return task_; }

 private:
  struct Features;
  std::unique_ptr<Features> features_;
  VisualTask task_;
};

}  // namespace lineservo::servo
