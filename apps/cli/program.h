#pragma once

namespace lineservo::apps {

/// The whole command line, for `main`. Returns the exit code: 0 done, 1 the mission or check failed, 2 wrong
/// usage or bad input. What goes wrong is told on stderr, never thrown. Call it once; controllers of one's
/// own are to be added before, by servo::add_controller().
int run_program(int argc, char** argv);

inline constexpr int kDone = 0;
inline constexpr int kFailed = 1;
inline constexpr int kBadInput = 2;

}  // namespace lineservo::apps
