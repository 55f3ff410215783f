#pragma once

namespace lineservo::vehicle {

/// How a velocity should answer its set-point when acceleration follows its command with a lag τ:
/// a_c = k₁ (v_set − v) − k₂ a within ±a_max, ȧ = (a_c − a)/τ, v̇ = a. The vehicle is driven with a_c and
/// corrected towards v, so the correction never has to do what the lag forbids.
class ReferenceAxis {
 public:
  /// How the axis answers: a lag, then a second order, with a limit.
  struct Answer {
    double lag_s;
    double bandwidth_per_s;
    double damping;
    double max_acceleration_m_s2;
  };
  ReferenceAxis(const Answer& answer, double period_s);

  /// One period on; returns a_c.
  double step(double target_m_s);
  void reset(double velocity_m_s);
  double velocity_m_s() const { return velocity_m_s_; }
  double acceleration_m_s2() const { return acceleration_m_s2_; }
  /// For a turn of the frame.
  void set_velocity(double velocity_m_s) { velocity_m_s_ = velocity_m_s; }

 private:
  double period_s_, lag_s_, k1_, k2_, max_acceleration_m_s2_;
  double velocity_m_s_ = 0.0, acceleration_m_s2_ = 0.0;
};

}  // namespace lineservo::vehicle
