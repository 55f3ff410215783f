#include "apps/cli/evaluate_faults_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>

#include "apps/cli/interrupt.h"
#include "apps/cli/list_option.h"
#include "apps/cli/number_option.h"
#include "apps/cli/program.h"
#include "apps/cli/study_progress.h"
#include "apps/compare/parallel.h"
#include "apps/evaluate/fault_report.h"
#include "apps/output/json_text.h"
#include "apps/output/result_folder.h"
#include "servo/law/controllers.h"

namespace lineservo::apps {
namespace {

struct Arguments {
  FaultStudyOptions options;
  std::vector<std::string> instructions;
  int jobs = default_jobs();
  std::optional<std::string> out;
  bool json = false;
};

int evaluate(const Arguments& arguments) {
  FaultStudyOptions options = arguments.options;
  if (!arguments.instructions.empty()) options.instructions = arguments.instructions;
  std::optional<ResultFolder> folder;
  if (arguments.out)
    folder.emplace(*arguments.out, std::vector<std::string>{"evaluation.csv", "evaluation.json"});
  watch_for_interrupt();
  StudyProgress progress("evaluate faults", "flights");
  const auto rows = study_faults(options, arguments.jobs, [&](std::size_t done, std::size_t all) {
    progress.show(done, all);
    return !interrupted();
  });
  progress.clear();
  if (!rows) {
    say_nothing_is_written("evaluate faults");
    return kFailed;
  }
  const std::string json = json_text(fault_json(options, *rows), 2);
  if (folder) {
    folder->write("evaluation.csv", fault_csv(*rows));
    folder->write("evaluation.json", json);
    folder->publish();
  }
  fmt::print("{}", arguments.json ? json : fault_table(*rows));
  if (arguments.out && !arguments.json) fmt::print("\nwritten to {}\n", *arguments.out);
  return all_safe(*rows) ? kDone : kFailed;
}

}  // namespace

void add_evaluate_faults_command(CLI::App& group, int& exit_code) {
  const auto arguments = std::make_shared<Arguments>();
  Arguments& a = *arguments;
  CLI::App* command = group.add_subcommand(
      "faults", "flights in which something goes wrong: how they end, and how far from paint they come");
  add_list_option(*command, "--instructions", a.instructions, "flown in turn (default: of all zones)");
  add_list_option(*command, "--faults", a.options.faults,
                  "only those whose names begin so, separated by commas (default: all)");
  command->add_option("--controller", a.options.controller, "the law that flies (default ibvs)");
  command->add_option("--conditions", a.options.conditions,
                      "conditions that ship, or a YAML file (default paper)");
  add_whole_option(*command, "--runs", a.options.runs, 1, 1000000, "flights of each fault");
  add_seed_option(*command, a.options.seed, "seed of the first flight; the next has the next");
  add_whole_option(*command, "--jobs", a.jobs, 1, kMostJobs,
                   "flights at a time, as many as cores if not given");
  command
      ->add_option_function<std::string>(
          "--set", [&a](const std::string& s) { a.options.overrides.push_back(s); },
          "KEY=VALUE: any setting of config.yaml, for every flight; may be repeated")
      ->trigger_on_parse();
  command->add_option("--out", a.out, "folder for evaluation.json and evaluation.csv");
  command->add_flag("--json", a.json, "print evaluation.json instead of the table");
  command->callback([arguments, &exit_code] { exit_code = evaluate(*arguments); });
}

}  // namespace lineservo::apps
