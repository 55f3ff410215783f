#pragma once

namespace lineservo::servo {

/// Gains of a PID loop: the output over the error, over its integral in seconds, and over its rate a second.
struct PidGains {
  double kp = 0.0;
  double ki = 0.0;
  double kd = 0.0;
};

/// One PID loop in time (grid §V):   out = K_p e + K_i ∫e dt + K_d ė, within ± limit; the integral stops
/// growing while the output is clipped.
class PidLoop {
 public:
  void reset() { *this = PidLoop(); }
  /// `dt_s` since the update before; 0 or less: the integral and the derivative stay as they are.
  double update(double error, double dt_s, const PidGains& gains, double limit);

 private:
  double integral_ = 0.0;
  double derivative_ = 0.0;
  double previous_ = 0.0;
  bool has_previous_ = false;
};

}  // namespace lineservo::servo
