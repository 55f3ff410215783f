#include "apps/cli/program.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <new>

#include "apps/cli/calibrate_command.h"
#include "apps/cli/compare_command.h"
#include "apps/cli/detect_command.h"
#include "apps/cli/evaluate_command.h"
#include "apps/cli/fly_command.h"
#include "apps/cli/import_track_command.h"
#include "apps/cli/list_commands.h"
#include "apps/cli/replay_command.h"
#include "apps/cli/report_command.h"
#include "apps/cli/test_command.h"
#include "apps/cli/train_command.h"
#include "apps/cli/tune_command.h"
#include "apps/cli/watch_command.h"
#include "apps/config/input_error.h"
#include "apps/config/program_name.h"
#include "apps/version.h"

namespace lineservo::apps {
namespace {

/// One line on stderr, whatever the message.
void complain(std::string message) {
  for (char& c : message) c = c == '\n' ? ' ' : c;
  // Not by a call that throws: a stderr that is closed must not turn a complaint into a crash.
  std::fputs(fmt::format("lineservo: {}\n", message).c_str(), stderr);
}

/// What a parse failed on that was none of a command's words.
std::string unknown_command(const CLI::App& app) {
  const auto chosen = app.get_subcommands();
  if (!chosen.empty()) return unknown_command(*chosen.front());
  const std::vector<std::string> words = app.remaining();
  const std::vector<const CLI::App*> commands = app.get_subcommands([](const CLI::App*) { return true; });
  if (words.empty() || words.front().starts_with('-') || commands.empty()) return {};
  std::string names;
  for (const CLI::App* command : commands) names += (names.empty() ? "" : ", ") + command->get_name();
  return fmt::format("unknown command '{}'; allowed: {}", words.front(), names);
}

std::string fault_of(const CLI::App& app, const CLI::ParseError& error) {
  const std::string unknown = unknown_command(app);
  return (unknown.empty() ? error.what() : unknown) + fmt::format(" ({} --help tells more)", program_name());
}

int parse_and_run(CLI::App& app, int argc, char** argv, const int& exit_code) try {
  app.parse(argc, argv);
  return exit_code;
} catch (const CLI::Success& help) {
  return app.exit(help);
} catch (const CLI::ParseError& error) {
  complain(fault_of(app, error));
  return kBadInput;
}

void add_commands(CLI::App& app, int& exit_code) {
  app.set_version_flag("--version", std::string(kVersion));
  app.require_subcommand(1);
  add_fly_command(app, exit_code);
  add_compare_command(app, exit_code);
  add_detect_command(app, exit_code);
  add_evaluate_command(app, exit_code);
  add_watch_command(app, exit_code);
  add_replay_command(app, exit_code);
  add_import_track_command(app);
  add_calibrate_command(app);
  add_list_commands(app);
  add_report_command(app, exit_code);
  add_test_command(app);
  add_train_command(app);
  add_tune_command(app, exit_code);
}

int run(int argc, char** argv) try {
  CLI::App app("lineservo: a quadrotor follows painted floor lines by visual servoing.", program_name());
  int exit_code = kDone;
  add_commands(app, exit_code);
  return parse_and_run(app, argc, argv, exit_code);
} catch (const InputError& error) {
  complain(error.what());
  return kBadInput;
} catch (const std::invalid_argument& error) {
  complain(error.what());
  return kBadInput;
} catch (const std::bad_alloc&) {
  complain("out of memory");
  return kFailed;
} catch (const std::exception& error) {
  if (std::ferror(stdout) != 0) return kDone;  // told by the caller
  complain(std::string("internal fault: ") + error.what());
  return kFailed;
}

}  // namespace

int run_program(int argc, char** argv) {
  if (argc > 0) program_name() = std::filesystem::path(argv[0]).filename();
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is an error of its writer, as on a full disk
  const int exit_code = run(argc, argv);
  errno = 0;
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return exit_code;
  complain(std::string("standard output cannot be written") + (errno == 0 ? "" : ": ") +
           (errno == 0 ? "" : std::strerror(errno)));
  return kBadInput;
}

std::optional<std::string> fault_in(std::vector<std::string> words) {
  CLI::App app;
  int exit_code = kDone;
  add_commands(app, exit_code);
  app.parse_complete_callback([] { throw CLI::Success(); });  // comes before any command is carried out
  std::reverse(words.begin(), words.end());                   // as CLI11 takes them
  try {
    app.parse(words);
  } catch (const CLI::Success&) {
  } catch (const CLI::ParseError& error) {
    return fault_of(app, error);
  }
  return std::nullopt;
}

}  // namespace lineservo::apps
