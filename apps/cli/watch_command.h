#pragma once

namespace CLI {
class App;
}

namespace lineservo::apps {

/// `lineservo watch`: perception and control on frames that come from elsewhere. Sets `exit_code` when it has
/// run.
void add_watch_command(CLI::App& app, int& exit_code);

}  // namespace lineservo::apps
