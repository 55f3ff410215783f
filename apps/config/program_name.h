#pragma once

#include <string>

namespace lineservo::apps {

/// What the program is called in the commands that it prints: "lineservo", or the name of a program of one's
/// own that has the command line. Written once, by run_program().
inline std::string& program_name() {
  static std::string name = "lineservo";
  return name;
}

}  // namespace lineservo::apps
