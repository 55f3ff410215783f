#pragma once

#include <Eigen/Core>
#include <memory>

#include "features/geometry/points.h"
#include "servo/task/visual_task.h"

namespace lineservo::servo {

/// Task of rank 3: a floor point below the camera (vpFeaturePoint) at a height (vpFeatureDepth). The null
/// space is the yaw about that point. With an angle it becomes of rank 4: the line's θ (vpFeatureLine) is
/// brought to zero as well.
class PointTask {
 public:
  enum class Heading { free, on_line };
  PointTask(const AdaptiveGain& gain, Heading heading);
  ~PointTask();

  /// `point`: the floor point now. `theta_rad`: the line's angle, used when the heading is on the line.
  /// `yaw_rate_rad_s`: secondary motion, used when it is free. `drift_H_m_s`: motion (forward, left) that the
  /// vehicle does not know of.
  TaskSolution solve(features::LevelPoint point, double theta_rad, double height_m, double desired_height_m,
                     double yaw_rate_rad_s, const Eigen::Vector2d& drift_H_m_s);

  const VisualTask& task() const { return task_; }

 private:
  struct Features;
  std::unique_ptr<Features> features_;
  Heading heading_;
  VisualTask task_;
};

}  // namespace lineservo::servo
