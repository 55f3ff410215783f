#pragma once

#include <string>

namespace lineservo::apps {

/// A word of a command that is printed to be typed: in single quotes unless it is plain.
std::string for_shell(const std::string& word);

}  // namespace lineservo::apps
