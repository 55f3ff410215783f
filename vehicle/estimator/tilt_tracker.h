#pragma once

#include "vehicle/attitude.h"

namespace lineservo::vehicle {

/// Roll and pitch that follow the gyro and are pulled slowly to the levelled attitude. The levelled one is
/// right on the long run but wanders; this one hardly wanders, so that what is left of gravity in the
/// horizontal specific force is nearly constant and the velocity filter can learn it.
class TiltTracker {
 public:
  TiltTracker(double roll_rad, double pitch_rad) : roll_rad_(roll_rad), pitch_rad_(pitch_rad) {}

  void step(const Eigen::Vector3d& gyro_B_rad_s, double levelled_roll_rad, double levelled_pitch_rad,
            double period_s);
  double roll_rad() const { return roll_rad_; }
  double pitch_rad() const { return pitch_rad_; }

 private:
  double roll_rad_, pitch_rad_;
};

}  // namespace lineservo::vehicle
