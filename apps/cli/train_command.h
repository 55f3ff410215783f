#pragma once

namespace CLI {
class App;
}

namespace lineservo::apps {

/// `lineservo train-colour`: trains the colour model that data/models/ ships, from generated colours.
void add_train_command(CLI::App& app);

}  // namespace lineservo::apps
