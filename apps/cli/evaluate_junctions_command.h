#pragma once

namespace CLI {
class App;
}

namespace lineservo::apps {

/// `lineservo evaluate junctions`: both recognisers on the same frames. Sets `exit_code` when it has run.
void add_evaluate_junctions_command(CLI::App& group, int& exit_code);

}  // namespace lineservo::apps
