#pragma once

namespace lineservo::apps {

/// From now on Ctrl-C does not end the program: interrupted() tells.
void watch_for_interrupt();
bool interrupted();

}  // namespace lineservo::apps
