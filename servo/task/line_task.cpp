#include "servo/task/line_task.h"

#include <visp3/visual_features/vpFeatureDepth.h>
#include <visp3/visual_features/vpFeatureLine.h>

#include <cmath>

namespace lineservo::servo {

struct LineTask::Features {
  vpFeatureLine line, desired_line;
  vpFeatureDepth depth, desired_depth;
};

LineTask::LineTask(const AdaptiveGain& gain, InteractionMatrix matrix)
    : features_(std::make_unique<Features>()), task_(gain, matrix) {
  features_->desired_line.buildFrom(0.0, 0.0);
  features_->desired_depth.buildFrom(0.0, 0.0, 1.0, 0.0);
  task_.add(features_->line, features_->desired_line, vpBasicFeature::FEATURE_ALL, 2);
  task_.add(features_->depth, features_->desired_depth, vpBasicFeature::FEATURE_ALL, 1);
}

LineTask::~LineTask() = default;

// The floor in the level camera frame is the plane 0·X + 0·Y + 1·Z − h = 0. With it ρ̇ = v_left / h on the
// line.
TaskSolution LineTask::solve(double rho, double theta_rad, double height_m, double desired_height_m,
                             double forward_m_s, double drift_m_s, double bend_rad_s) {
  if (!(height_m > 0.0)) return {};  // on the floor nothing is seen; NaN too
  features_->line.buildFrom(rho, theta_rad, 0.0, 0.0, 1.0, -height_m);
  features_->depth.buildFrom(0.0, 0.0, height_m, std::log(height_m / desired_height_m));
  features_->desired_line.setABCD(0.0, 0.0, 1.0, -desired_height_m);
  features_->desired_depth.buildFrom(0.0, 0.0, desired_height_m, 0.0);
  const Eigen::Vector3d error_rate(drift_m_s / height_m, bend_rad_s, 0.0);
  return task_.solve({forward_m_s, 0.0, 0.0, 0.0}, error_rate);
}

}  // namespace lineservo::servo
