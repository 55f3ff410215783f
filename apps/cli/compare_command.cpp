#include "apps/cli/compare_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "apps/cli/interrupt.h"
#include "apps/cli/list_option.h"
#include "apps/cli/number_option.h"
#include "apps/cli/program.h"
#include "apps/cli/study_progress.h"
#include "apps/compare/comparison_table.h"
#include "apps/compare/parallel.h"
#include "apps/compare/presets.h"
#include "apps/config/input_error.h"
#include "apps/output/json_text.h"
#include "apps/output/report_file.h"
#include "apps/output/result_folder.h"
#include "apps/output/result_kind.h"
#include "apps/report/comparison_data.h"
#include "servo/law/controllers.h"

namespace lineservo::apps {
namespace {

const std::vector<std::string> kResults = {"comparison.csv", "distribution.csv", kReportFile,
                                           "comparison.json"};

struct Arguments {
  Block block;  ///< without a preset
  ComparisonOptions options;
  std::string tuning = "both";
  std::optional<std::string> preset, conditions, out;
  int jobs = default_jobs();
  bool json = false;
};

std::vector<std::string> all_controllers() {
  std::vector<std::string> names;
  for (const servo::Controller& c : servo::controllers()) names.emplace_back(c.name);
  return names;
}

/// What was typed, or its defaults.
std::vector<Block> typed_blocks(const Arguments& a) {
  Block block = a.block;
  if (block.controllers.empty()) block.controllers = all_controllers();
  if (block.instructions.empty()) block.instructions = {"a03", "a13", "a23", "a53"};
  return block.layouts.empty() ? on_floors_of_zones(block) : std::vector<Block>{block};
}

/// The preset's flights by those controllers alone that were typed.
std::vector<Block> preset_blocks(const Arguments& a) {
  std::vector<Block> blocks = find_preset(*a.preset).blocks;
  const std::vector<std::string>& wanted = a.block.controllers;
  if (wanted.empty()) return blocks;
  for (Block& block : blocks) {
    std::erase_if(block.controllers, [&wanted](const std::string& name) {
      return std::find(wanted.begin(), wanted.end(), name) == wanted.end();
    });
  }
  std::erase_if(blocks, [](const Block& block) { return block.controllers.empty(); });
  if (blocks.empty())
    throw InputError(fmt::format("--preset {}: none of --controllers flies in it", *a.preset));
  return blocks;
}

ComparisonOptions options_of(const Arguments& a) {
  for (const std::string& name : a.block.controllers) servo::find_controller(name);
  ComparisonOptions options = a.options;
  options.blocks = a.preset ? preset_blocks(a) : typed_blocks(a);
  options.conditions =
      a.conditions.value_or(std::string(a.preset ? find_preset(*a.preset).conditions : "paper"));
  options.tuning = a.tuning == "both"    ? Tuning::both
                   : a.tuning == "tuned" ? Tuning::tuned
                                         : Tuning::published;
  return options;
}

void write_results(ResultFolder& folder, const ComparisonResult& result, const std::string& json) {
  const std::string csv = comparison_csv(result), distribution = distribution_csv(result);
  watch_for_interrupt();  // the files, once begun, are written whole
  folder.write("comparison.csv", csv);
  folder.write("distribution.csv", distribution);
  write_report(folder, "Comparison · lineservo", [&] { return comparison_data(result); });
  folder.write("comparison.json", json);
  folder.publish();
}

std::string text_of(const Arguments& a, const ComparisonResult& result) {
  const bool histogram = a.preset && find_preset(*a.preset).histogram;
  return comparison_table(result) + (histogram ? error_histogram(result) : "") +
         (a.out ? fmt::format("\nwritten to {}\n", *a.out) : "");
}

int compare(const Arguments& arguments) {
  const ComparisonOptions options = options_of(arguments);
  end_on_interrupt("compare");
  Comparison comparison(options);
  std::optional<ResultFolder> folder;
  if (arguments.out) {
    refuse_other_kinds(*arguments.out, ResultKind::comparison, "--out");
    folder.emplace(*arguments.out, kResults);
  }

  watch_for_interrupt();
  StudyProgress progress("compare", "flights");
  std::size_t flown = 0;
  auto contestants = comparison.fly(arguments.jobs, [&](std::size_t done) {
    progress.show(flown = done, comparison.flights());
    return !interrupted();
  });
  progress.clear();
  if (!contestants) {
    fmt::print(stderr, "lineservo: compare was broken off after {} of {} flights; nothing is written\n",
               flown, comparison.flights());
    return kFailed;
  }
  end_on_interrupt("compare");
  const ComparisonResult result{options, arguments.preset.value_or(""), std::move(*contestants)};
  const std::string json = json_text(comparison_json(result), 2);
  const std::string text = arguments.json ? json : text_of(arguments, result);
  if (folder) write_results(*folder, result, json);
  fmt::print("{}", text);
  return kDone;
}

void add_flight_options(CLI::App& command, Arguments& a) {
  CLI::Option* instructions =
      add_list_option(command, "--instructions", a.block.instructions, "default a03,a13,a23,a53");
  CLI::Option* layouts =
      add_list_option(command, "--layout", a.block.layouts,
                      "floors, or YAML files, each flown by all (default: that of each instruction's zone)");
  CLI::Option* speeds = add_list_option(command, "--speeds", a.block.speeds_m_s,
                                        "speeds in m/s, each flown by all (default: that of the conditions)");
  CLI::Option* own = command.add_flag("--own-speed", a.block.own_speed,
                                      "each controller at its paper's speed, where that gives one");
  own->excludes(speeds);
  CLI::Option* preset = command.add_option(
      "--preset", a.preset, "a paper's experiment, its figures beside: topology, lfpf, grid-flight, vtp");
  for (CLI::Option* other : {instructions, layouts, speeds, own}) preset->excludes(other);
  add_list_option(command, "--controllers", a.block.controllers, "default: all that ship, or the preset's");
  command.add_option("--conditions", a.conditions,
                     "conditions that ship, a YAML file, or two with .. between, from which each flight "
                     "draws its own (default paper, or the preset's)");
}

void add_run_options(CLI::App& command, Arguments& a) {
  command
      .add_option("--tuning", a.tuning,
                  "parameters as published, as tuned, or both where both ship (default)")
      ->check(CLI::IsMember({"published", "tuned", "both"}));
  command.add_option("--reference", a.options.reference,
                     "the controller that the others are held against, pair by pair (default ibvs)");
  add_whole_option(command, "--runs", a.options.runs, 1, 1000000, "flights of each instruction");
  add_seed_option(command, a.options.seed, "seed of the first run; the next has the next");
  add_whole_option(command, "--jobs", a.jobs, 1, kMostJobs,
                   "flights at a time, as many as cores if not given");
  command
      .add_option_function<std::string>(
          "--set", [&a](const std::string& s) { a.options.overrides.push_back(s); },
          "KEY=VALUE: any setting of config.yaml, for every flight; may be repeated")
      ->trigger_on_parse();
  command.add_option("--out", a.out,
                     "folder for comparison.json, comparison.csv, distribution.csv and report.html");
  command.add_flag("--json", a.json, "print comparison.json instead of the table");
}

}  // namespace

void add_compare_command(CLI::App& app, int& exit_code) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command =
      app.add_subcommand("compare", "fly every controller on the same flights and compare them");
  add_flight_options(*command, *arguments);
  add_run_options(*command, *arguments);
  command->callback([arguments, &exit_code] { exit_code = compare(*arguments); });
}

}  // namespace lineservo::apps
