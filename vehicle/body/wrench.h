#pragma once

#include <Eigen/Core>

namespace lineservo::vehicle {

/// Force and moment about the body origin, in B.
struct Wrench {
  Eigen::Vector3d force_B_N = Eigen::Vector3d::Zero();
  Eigen::Vector3d torque_B_Nm = Eigen::Vector3d::Zero();

  Wrench& operator+=(const Wrench& other) {
    force_B_N += other.force_B_N;
    torque_B_Nm += other.torque_B_Nm;
    return *this;
  }
};

}  // namespace lineservo::vehicle
