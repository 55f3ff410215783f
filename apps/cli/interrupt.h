#pragma once

#include <string>

namespace lineservo::apps {

// Ctrl-C stands for SIGTERM and SIGHUP as well, but for a SIGHUP that nohup has ignored.

/// From now on Ctrl-C does not end the program: interrupted() tells.
void watch_for_interrupt();
bool interrupted();

/// From now on Ctrl-C ends the program at once, with the line that say_nothing_is_written() says and exit
/// code 1: for work that cannot be asked in between, as long as nothing is written.
void end_on_interrupt(const std::string& command);

/// "lineservo: COMMAND: interrupted; nothing is written", on stderr.
void say_nothing_is_written(const std::string& command);

}  // namespace lineservo::apps
