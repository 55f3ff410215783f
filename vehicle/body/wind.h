#pragma once

#include <Eigen/Core>

#include "vehicle/time.h"

namespace lineservo::vehicle {

/// The motion of the air in W.
class Wind {
 public:
  virtual ~Wind() = default;
  /// Asked once a step, with times that never go back.
  virtual Eigen::Vector3d velocity_W(Time t, const Eigen::Vector3d& p_WB) = 0;
};

/// The same everywhere and always. The direction is where it blows to, from +x counter-clockwise.
class ConstantWind : public Wind {
 public:
  explicit ConstantWind(double speed_m_s = 0.0, double direction_rad = 0.0);
  Eigen::Vector3d velocity_W(Time, const Eigen::Vector3d&) override { return v_W_; }

 private:
  Eigen::Vector3d v_W_;
};

}  // namespace lineservo::vehicle
