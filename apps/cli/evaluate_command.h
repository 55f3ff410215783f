#pragma once

namespace CLI {
class App;
}

namespace lineservo::apps {

/// `lineservo evaluate …`: accuracy tables on generated frames with exact ground truth. Sets `exit_code` when
/// it has run.
void add_evaluate_command(CLI::App& app, int& exit_code);

}  // namespace lineservo::apps
