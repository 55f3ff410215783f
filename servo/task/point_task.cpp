#include "servo/task/point_task.h"

#include <visp3/visual_features/vpFeatureDepth.h>
#include <visp3/visual_features/vpFeatureLine.h>
#include <visp3/visual_features/vpFeaturePoint.h>

#include <cmath>

namespace lineservo::servo {

struct PointTask::Features {
  vpFeaturePoint point, desired_point;
  vpFeatureDepth depth, desired_depth;
  vpFeatureLine line, desired_line;
};

PointTask::PointTask(const AdaptiveGain& gain, Heading heading)
    : features_(std::make_unique<Features>()), heading_(heading), task_(gain) {
  features_->desired_point.buildFrom(0.0, 0.0, 1.0);
  features_->desired_depth.buildFrom(0.0, 0.0, 1.0, 0.0);
  features_->desired_line.buildFrom(0.0, 0.0);
  task_.add(features_->point, features_->desired_point, vpBasicFeature::FEATURE_ALL, 2);
  task_.add(features_->depth, features_->desired_depth, vpBasicFeature::FEATURE_ALL, 1);
  if (heading_ == Heading::on_line) {
    task_.add(features_->line, features_->desired_line, vpFeatureLine::selectTheta(), 1);
  }
}

PointTask::~PointTask() = default;

// A drift of the vehicle by d moves the point in the level camera by ẋ = d_left / h, ẏ = d_forward / h.
TaskSolution PointTask::solve(features::LevelPoint point, double theta_rad, double height_m,
                              double desired_height_m, double yaw_rate_rad_s,
                              const Eigen::Vector2d& drift_H_m_s) {
  if (!(height_m > 0.0)) return {};  // on the floor nothing is seen; NaN too
  features_->point.buildFrom(point.x, point.y, height_m);
  features_->depth.buildFrom(0.0, 0.0, height_m, std::log(height_m / desired_height_m));
  Eigen::VectorXd error_rate = Eigen::VectorXd::Zero(heading_ == Heading::on_line ? 4 : 3);
  error_rate.head<2>() << drift_H_m_s.y() / height_m, drift_H_m_s.x() / height_m;
  if (heading_ == Heading::on_line) features_->line.buildFrom(0.0, theta_rad, 0.0, 0.0, 1.0, -height_m);
  return task_.solve({0.0, 0.0, 0.0, yaw_rate_rad_s}, error_rate);
}

}  // namespace lineservo::servo
