#include "vehicle/sensors/gauss_markov.h"

#include <cmath>

namespace lineservo::vehicle {

GaussMarkov::GaussMarkov(double sigma, double correlation_s, double period_s, Random& random)
    : phi_(std::exp(-period_s / correlation_s)),
      drive_sigma_(sigma * std::sqrt(1.0 - phi_ * phi_)),
      value_(random.normal(sigma)) {}

}  // namespace lineservo::vehicle
