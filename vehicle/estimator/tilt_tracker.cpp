#include "vehicle/estimator/tilt_tracker.h"

namespace lineservo::vehicle {
namespace {
constexpr double kPull_s = 20.0;
}

// φ ← φ + T (φ̇_gyro + (φ_levelled − φ)/τ), the same for θ
void TiltTracker::step(const Eigen::Vector3d& gyro_B_rad_s, double levelled_roll_rad,
                       double levelled_pitch_rad, double period_s) {
  const RollPitchYaw rates = euler_rates(gyro_B_rad_s, roll_rad_, pitch_rad_);
  const double roll_step = rates.roll_rad + (levelled_roll_rad - roll_rad_) / kPull_s;
  const double pitch_step = rates.pitch_rad + (levelled_pitch_rad - pitch_rad_) / kPull_s;
  roll_rad_ += period_s * roll_step;
  pitch_rad_ += period_s * pitch_step;
}

}  // namespace lineservo::vehicle
