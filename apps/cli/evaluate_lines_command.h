#pragma once

namespace CLI {
class App;
}

namespace lineservo::apps {

/// `lineservo evaluate lines`: every line method on generated frames. Sets `exit_code` when it has run.
void add_evaluate_lines_command(CLI::App& group, int& exit_code);

}  // namespace lineservo::apps
