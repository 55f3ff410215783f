#pragma once

#include <stdexcept>
#include <string>

namespace lineservo::apps {

/// Wrong usage or bad input: one line that says what, where and what is allowed. The program ends with exit
/// code 2.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace lineservo::apps
