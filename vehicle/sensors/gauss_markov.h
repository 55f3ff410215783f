#pragma once

#include "vehicle/random.h"

namespace lineservo::vehicle {

/// First-order Gauss–Markov process, stationary from the start: x(t+T) = φ x(t) + σ √(1−φ²) n, φ = e^(−T/τ).
class GaussMarkov {
 public:
  GaussMarkov(double sigma, double correlation_s, double period_s, Random& random);
  double value() const { return value_; }
  void step(Random& random) { value_ = phi_ * value_ + random.normal(drive_sigma_); }

 private:
  double phi_, drive_sigma_, value_;
};

}  // namespace lineservo::vehicle
