#include "apps/cli/evaluate_lines_command.h"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>

#include "apps/cli/interrupt.h"
#include "apps/cli/list_option.h"
#include "apps/cli/number_option.h"
#include "apps/cli/program.h"
#include "apps/evaluate/line_evaluation.h"
#include "apps/evaluate/line_report.h"
#include "apps/output/json_text.h"
#include "apps/output/result_folder.h"

namespace lineservo::apps {
namespace {

struct Arguments {
  LineEvaluationOptions options;
  std::optional<std::string> out;
  bool json = false;
};

// On a terminal one line that is written over; false ends the evaluation.
bool show_progress(double share) {
  if (::isatty(STDERR_FILENO)) fmt::print(stderr, "\revaluate lines: {:3.0f} % ", 100.0 * share);
  return !interrupted();
}

int evaluate(const Arguments& arguments) {
  watch_for_interrupt();
  std::optional<ResultFolder> folder;
  if (arguments.out)
    folder.emplace(*arguments.out, std::vector<std::string>{"evaluation.csv", "evaluation.json"});
  const std::vector<LineEvaluationRow> rows = evaluate_lines(arguments.options, show_progress);
  if (::isatty(STDERR_FILENO)) fmt::print(stderr, "\r\033[K");
  if (interrupted()) {
    say_nothing_is_written("evaluate lines");
    return kFailed;
  }
  const std::string json = json_text(lines_json(arguments.options, rows), 2);
  if (folder) {
    folder->write("evaluation.csv", lines_csv(rows));
    folder->write("evaluation.json", json);
    folder->publish();
  }
  fmt::print("{}", arguments.json ? json : lines_table(rows));
  if (arguments.out && !arguments.json) fmt::print("\nwritten to {}\n", *arguments.out);
  return kDone;
}

}  // namespace

void add_evaluate_lines_command(CLI::App& group, int& exit_code) {
  const auto arguments = std::make_shared<Arguments>();
  Arguments& a = *arguments;
  CLI::App* command = group.add_subcommand(
      "lines", "line methods on clean, real-like and harsh frames, 1920x1080 and 640x480");
  add_whole_option(*command, "--frames", a.options.frames, 1, 100000, "frames of each level and size");
  add_seed_option(*command, a.options.seed, "seed of everything random");
  add_list_option(*command, "--methods", a.options.methods, "only these, separated by commas (default: all)");
  add_list_option(*command, "--levels", a.options.levels,
                  "only these of clean, real-like, harsh (default: all)");
  command->add_option("--empty", a.options.empty_share,
                      "share of the frames that show no line, 0 to 1 (default 0.1)");
  command->add_option("--out", a.out, "folder for evaluation.json and evaluation.csv");
  command->add_flag("--json", a.json, "print evaluation.json instead of the table");
  command->callback([arguments, &exit_code] { exit_code = evaluate(*arguments); });
}

}  // namespace lineservo::apps
