#include "apps/cli/evaluate_junctions_command.h"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>

#include "apps/cli/interrupt.h"
#include "apps/cli/number_option.h"
#include "apps/cli/program.h"
#include "apps/evaluate/junction_report.h"
#include "apps/output/json_text.h"
#include "apps/output/result_folder.h"

namespace lineservo::apps {
namespace {

struct Arguments {
  std::uint64_t seed = 1;
  std::optional<std::string> out;
  bool json = false;
};

void show_progress(std::size_t done, std::size_t all) {
  if (::isatty(STDERR_FILENO)) fmt::print(stderr, "\revaluate junctions: case {} of {} ", done + 1, all);
}

int evaluate(const Arguments& arguments) {
  end_on_interrupt("evaluate junctions");
  std::optional<ResultFolder> folder;
  if (arguments.out)
    folder.emplace(*arguments.out, std::vector<std::string>{"evaluation.csv", "evaluation.json"});
  std::vector<JunctionCase> cases = junction_cases(arguments.seed);
  run(cases, show_progress);
  if (::isatty(STDERR_FILENO)) fmt::print(stderr, "\r\033[K");
  watch_for_interrupt();  // the results, once begun, are written whole
  const std::string json = json_text(junction_json(cases), 2);
  if (folder) {
    folder->write("evaluation.csv", junction_csv(cases));
    folder->write("evaluation.json", json);
    folder->publish();
  }
  fmt::print("{}", arguments.json ? json : junction_table(cases));
  if (arguments.out && !arguments.json) fmt::print("\nwritten to {}\n", *arguments.out);
  return kDone;
}

}  // namespace

void add_evaluate_junctions_command(CLI::App& group, int& exit_code) {
  const auto arguments = std::make_shared<Arguments>();
  Arguments& a = *arguments;
  CLI::App* command = group.add_subcommand(
      "junctions", "both recognisers along a03, a13, a23, a53 of warehouse and tape-warehouse");
  add_seed_option(*command, a.seed, "seed of everything random");
  command->add_option("--out", a.out, "folder for evaluation.json and evaluation.csv");
  command->add_flag("--json", a.json, "print evaluation.json instead of the table");
  command->callback([arguments, &exit_code] { exit_code = evaluate(*arguments); });
}

}  // namespace lineservo::apps
