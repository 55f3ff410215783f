#include "servo/task/sideways_task.h"

#include <visp3/visual_features/vpFeatureDepth.h>
#include <visp3/visual_features/vpFeaturePoint.h>

#include <cmath>

namespace lineservo::servo {

struct SidewaysTask::Features {
  vpFeaturePoint point, desired_point;
  vpFeatureDepth depth, desired_depth;
};

SidewaysTask::SidewaysTask(const AdaptiveGain& gain)
    : features_(std::make_unique<Features>()),
      task_(gain, InteractionMatrix::current, VisualTask::Yaw::held) {
  features_->desired_point.buildFrom(0.0, 0.0, 1.0);
  features_->desired_depth.buildFrom(0.0, 0.0, 1.0, 0.0);
  task_.add(features_->point, features_->desired_point, vpFeaturePoint::selectX(), 1);
  task_.add(features_->depth, features_->desired_depth, vpBasicFeature::FEATURE_ALL, 1);
}

SidewaysTask::~SidewaysTask() = default;

// ẋ = (v_left − x·v_up) / h − y·ω: the yaw that is held from outside and the drift are motions of the error
// that this task does not cause.
TaskSolution SidewaysTask::solve(features::LevelPoint point, double height_m, double desired_height_m,
                                 const KnownMotion& motion) {
  if (!(height_m > 0.0)) return {};  // on the floor nothing is seen; NaN too
  features_->point.buildFrom(point.x, point.y, height_m);
  features_->depth.buildFrom(0.0, 0.0, height_m, std::log(height_m / desired_height_m));
  const Eigen::Vector2d error_rate(motion.drift_m_s / height_m - point.y * motion.yaw_rate_rad_s, 0.0);
  return task_.solve({motion.forward_m_s, 0.0, 0.0, motion.yaw_rate_rad_s}, error_rate);
}

}  // namespace lineservo::servo
