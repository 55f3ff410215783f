#pragma once

namespace CLI {
class App;
}

namespace lineservo::apps {

/// `lineservo replay`: runs perception and control again on a recording. Sets `exit_code` when it has run.
void add_replay_command(CLI::App& app, int& exit_code);

}  // namespace lineservo::apps
