#pragma once

namespace CLI {
class App;
}

namespace lineservo::apps {

/// `lineservo evaluate faults`: flights in which something goes wrong. Sets `exit_code` when it has run.
void add_evaluate_faults_command(CLI::App& group, int& exit_code);

}  // namespace lineservo::apps
