#pragma once

#include <optional>
#include <string>
#include <vector>

namespace lineservo::apps {

/// The whole command line, for `main`. Returns the exit code: 0 done, 1 the mission or check failed, 2 wrong
/// usage or bad input. What goes wrong is told on stderr, never thrown. Call it once; controllers of one's
/// own are to be added before, by servo::add_controller().
int run_program(int argc, char** argv);

/// What the parser of the command line says against the words that follow the program's name, none if
/// nothing. Nothing is carried out, and what only a command itself finds is not found.
std::optional<std::string> fault_in(std::vector<std::string> words);

inline constexpr int kDone = 0;
inline constexpr int kFailed = 1;
inline constexpr int kBadInput = 2;

}  // namespace lineservo::apps
