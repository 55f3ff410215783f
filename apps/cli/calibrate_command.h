#pragma once

namespace CLI {
class App;
}

namespace lineservo::apps {

/// `lineservo calibrate`: a camera file from pictures of a chessboard.
void add_calibrate_command(CLI::App& app);

}  // namespace lineservo::apps
