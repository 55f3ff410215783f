#pragma once

#include <string>
#include <string_view>

namespace lineservo::vehicle {

/// Collects what is wrong with a set of parameters, so that one exception can list all of it.
class Faults {
 public:
  explicit Faults(std::string_view subject) : subject_(subject) {}

  /// Notes `what is wrong, what is allowed` unless it holds. Write conditions so that NaN fails them.
  void require(bool holds, std::string_view fault);
  void require_positive(double value, std::string_view name);
  void require_not_negative(double value, std::string_view name);
  /// Throws std::invalid_argument when anything was noted.
  void throw_if_any() const;

 private:
  std::string subject_;
  std::string text_;
};

}  // namespace lineservo::vehicle
