#pragma once

namespace CLI {
class App;
}

namespace lineservo::apps {

/// `lineservo test`: runs the test suite of the build that the program belongs to.
void add_test_command(CLI::App& app);

}  // namespace lineservo::apps
