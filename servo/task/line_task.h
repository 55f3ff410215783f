#pragma once

#include <memory>

#include "servo/task/visual_task.h"

namespace lineservo::servo {

/// Task of rank 3: the line under the camera and straight ahead (vpFeatureLine, floor plane from the live
/// height), and the height (vpFeatureDepth of the point below). The null space is the motion along the line:
/// the forward speed.
class LineTask {
 public:
  explicit LineTask(const AdaptiveGain& gain, InteractionMatrix matrix = InteractionMatrix::current);
  ~LineTask();

  /// (ρ, θ): the line as it is now. `drift_m_s`: the sideways speed, to the left, that the vehicle does not
  /// know of. `bend_rad_s`: how fast θ grows because the line bends away under the forward motion.
  TaskSolution solve(double rho, double theta_rad, double height_m, double desired_height_m,
                     double forward_m_s, double drift_m_s, double bend_rad_s = 0.0);

  const VisualTask& task() const { return task_; }

 private:
  struct Features;
  std::unique_ptr<Features> features_;
  VisualTask task_;
};

}  // namespace lineservo::servo
