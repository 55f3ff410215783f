#pragma once

namespace CLI {
class App;
}

namespace lineservo::apps {

/// `lineservo layouts`, `controllers`, `conditions`: what ships, a line each.
void add_list_commands(CLI::App& app);

}  // namespace lineservo::apps
