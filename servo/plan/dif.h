#pragma once

#include <string>
#include <string_view>

namespace lineservo::servo {

/// A digital instruction (topology Tab. 1): zone letter and grid coordinates of the target, such as a13 or
/// a:12:3.
struct Dif {
  char zone = 'a';
  int i = 0;
  int j = 0;

  friend bool operator==(const Dif&, const Dif&) = default;
};

/// Throws std::invalid_argument, with what is allowed, for anything that is not an instruction.
Dif parse_dif(std::string_view text);

/// The canonical spelling: three characters where they suffice, a:12:3 otherwise.
std::string to_string(const Dif& dif);

}  // namespace lineservo::servo
