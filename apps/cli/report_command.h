#pragma once

namespace CLI {
class App;
}

namespace lineservo::apps {

/// report: writes the report of an earlier flight.
void add_report_command(CLI::App& app, int& exit_code);

}  // namespace lineservo::apps
