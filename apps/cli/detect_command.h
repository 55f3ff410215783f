#pragma once

namespace CLI {
class App;
}

namespace lineservo::apps {

/// `lineservo detect`: the lines and the junction in image files.
void add_detect_command(CLI::App& app, int& exit_code);

}  // namespace lineservo::apps
