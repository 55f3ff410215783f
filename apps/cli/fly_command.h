#pragma once

namespace CLI {
class App;
}

namespace lineservo::apps {

/// `lineservo fly`: flies one instruction in simulation. Sets `exit_code` when it has run.
void add_fly_command(CLI::App& app, int& exit_code);

}  // namespace lineservo::apps
