#include "apps/cli/program.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <exception>

#include "apps/cli/detect_command.h"
#include "apps/cli/evaluate_command.h"
#include "apps/cli/fly_command.h"
#include "apps/cli/list_commands.h"
#include "apps/cli/test_command.h"
#include "apps/cli/train_command.h"
#include "apps/config/input_error.h"
#include "apps/version.h"

namespace lineservo::apps {
namespace {

/// One line on stderr, whatever the message.
void complain(std::string message) {
  for (char& c : message) c = c == '\n' ? ' ' : c;
  // Not by a call that throws: a stderr that is closed must not turn a complaint into a crash.
  std::fputs(fmt::format("lineservo: {}\n", message).c_str(), stderr);
}

int parse_and_run(CLI::App& app, int argc, char** argv, const int& exit_code) try {
  app.parse(argc, argv);
  return exit_code;
} catch (const CLI::Success& help) {
  return app.exit(help);
} catch (const CLI::ParseError& error) {
  complain(std::string(error.what()) + " (lineservo --help tells more)");
  return kBadInput;
}

}  // namespace

int run_program(int argc, char** argv) try {
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is an error of its writer, as on a full disk
  CLI::App app("lineservo: a quadrotor follows painted floor lines by visual servoing.", "lineservo");
  app.set_version_flag("--version", std::string(kVersion));
  app.require_subcommand(1);
  int exit_code = kDone;
  add_fly_command(app, exit_code);
  add_detect_command(app, exit_code);
  add_evaluate_command(app, exit_code);
  add_list_commands(app);
  add_test_command(app);
  add_train_command(app);
  return parse_and_run(app, argc, argv, exit_code);
} catch (const InputError& error) {
  complain(error.what());
  return kBadInput;
} catch (const std::invalid_argument& error) {
  complain(error.what());
  return kBadInput;
} catch (const std::exception& error) {
  complain(std::string("internal fault: ") + error.what());
  return kFailed;
}

}  // namespace lineservo::apps
