#pragma once

namespace lineservo::servo {

/// Estimates how fast the vehicle drifts against its own odometry along one axis (velocity bias): an α–β
/// filter on the position that vision measures, driven by the odometry.
///   ŷ⁻ = ŷ + Δo + d̂·dt,   r = y − ŷ⁻,   ŷ = ŷ⁻ + (1 − p²)·r,   d̂ ← d̂ + (1 − p)²·r / dt,   p = exp(−dt/τ)
/// (critically damped; Benedict and Bordner 1962 for the form).
class DriftObserver {
 public:
  /// `time_constant_s` τ > 0; the estimate stays within ± `limit_m_s`.
  DriftObserver(double time_constant_s, double limit_m_s)
      : time_constant_s_(time_constant_s), limit_m_s_(limit_m_s) {}

  /// A measured position (metres), the odometry's own step since the measurement before, and the time between
  /// them.
  void update(double measured_m, double odometry_step_m, double dt_s);
  /// Starts the position anew (the next measurement is of something else); the drift stays.
  void restart() { has_position_ = false; }

  double drift_m_s() const { return drift_m_s_; }

 private:
  double time_constant_s_;
  double limit_m_s_;
  double position_m_ = 0.0;
  double drift_m_s_ = 0.0;
  bool has_position_ = false;
};

}  // namespace lineservo::servo
