#pragma once

namespace CLI {
class App;
}

namespace lineservo::apps {

/// import-track: traces a bitmap of lines into a layout file.
void add_import_track_command(CLI::App& app);

}  // namespace lineservo::apps
