#pragma once

namespace CLI {
class App;
}

namespace lineservo::apps {

/// `lineservo tune`: searches the parameters of laws, each with the same budget. Sets `exit_code` when it has
/// run.
void add_tune_command(CLI::App& app, int& exit_code);

}  // namespace lineservo::apps
