#pragma once

#include <memory>

#include "servo/task/visual_task.h"

namespace lineservo::servo {

/// Task of rank 3: the line under the camera and straight ahead (vpFeatureLine, floor plane from the live
/// height), and the height (vpFeatureDepth of the point below). The null space is the motion along the line:
/// the forward speed.
class LineTask {
 public:
  explicit LineTask(const AdaptiveGain& gain);
  ~LineTask();

  /// (ρ, θ): the line as it is now. `drift_m_s`: the sideways speed, to the left, that the vehicle does not
  /// know of.
  TaskSolution solve(double rho, double theta_rad, double height_m, double desired_height_m,
                     double forward_m_s, double drift_m_s);

  const VisualTask& task() const { return task_; }

 private:
  struct Features;
  std::unique_ptr<Features> features_;
  VisualTask task_;
};

}  // namespace lineservo::servo
