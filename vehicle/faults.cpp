#include "vehicle/faults.h"

#include <cmath>
#include <stdexcept>

namespace lineservo::vehicle {

void Faults::require(bool holds, std::string_view fault) {
  if (holds) return;
  if (!text_.empty()) text_ += "; ";
  text_ += fault;
}

void Faults::require_positive(double value, std::string_view name) {
  require(std::isfinite(value) && value > 0.0,
          std::string(name) + " is " + std::to_string(value) + ", must be finite and above 0");
}

void Faults::require_not_negative(double value, std::string_view name) {
  require(std::isfinite(value) && value >= 0.0,
          std::string(name) + " is " + std::to_string(value) + ", must be finite and not below 0");
}

void Faults::throw_if_any() const {
  if (!text_.empty()) throw std::invalid_argument(subject_ + ": " + text_);
}

}  // namespace lineservo::vehicle
