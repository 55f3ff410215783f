#pragma once

namespace CLI {
class App;
}

namespace lineservo::apps {

/// `lineservo compare`: every controller on the same flights. Sets `exit_code` when it has run.
void add_compare_command(CLI::App& app, int& exit_code);

}  // namespace lineservo::apps
