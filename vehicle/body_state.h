#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace lineservo::vehicle {

/// The true motion of the body B in the world W. For scoring and for the simulated sensors only.
struct BodyState {
  Eigen::Vector3d p_WB = Eigen::Vector3d::Zero();
  Eigen::Quaterniond q_WB = Eigen::Quaterniond::Identity();
  Eigen::Vector3d v_W = Eigen::Vector3d::Zero();
  Eigen::Vector3d w_B = Eigen::Vector3d::Zero();
};

}  // namespace lineservo::vehicle
