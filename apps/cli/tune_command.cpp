#include "apps/cli/tune_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "apps/cli/interrupt.h"
#include "apps/cli/number_option.h"
#include "apps/cli/program.h"
#include "apps/cli/repeats.h"
#include "apps/cli/study_progress.h"
#include "apps/compare/parallel.h"
#include "apps/compare/tuning.h"
#include "apps/output/json_text.h"
#include "apps/output/result_folder.h"
#include "apps/version.h"
#include "servo/law/controllers.h"

namespace lineservo::apps {
namespace {

using nlohmann::ordered_json;

struct Arguments {
  std::vector<std::string> controllers;
  TuningOptions options{60, default_jobs()};
  std::optional<std::string> out;
};

ordered_json json_of(const TuningResult& result) {
  ordered_json json = {{"controller", result.controller}};
  for (const TunableParameter& p : result.parameters)
    json["parameters"].push_back(
        {{"key", p.key}, {"published", p.published}, {"low", p.low}, {"high", p.high}});
  for (const TuningTrial& t : result.trials)
    json["trials"].push_back({{"values", t.values}, {"cost", t.cost}, {"failed", t.failed}});
  return json;
}

std::string text_of(const TuningResult& result) {
  const TuningTrial &before = result.published(), &after = result.best();
  std::string text = fmt::format(
      "{}: cost {:.4f} as published ({} failed), {:.4f} tuned ({} failed), {} points\n", result.controller,
      before.cost, before.failed, after.cost, after.failed, result.trials.size());
  for (std::size_t i = 0; i < result.parameters.size(); ++i) {
    const TunableParameter& p = result.parameters[i];
    text += fmt::format("  {:<45} {:>10.5g} -> {:<10.5g} in {:.5g} to {:.5g}\n", p.key, p.published,
                        after.values[i], p.low, p.high);
  }
  return text;
}

std::vector<std::string> results_of(const Arguments& arguments) {
  std::vector<std::string> names = {"tuning.json"};
  for (const std::string& name : arguments.controllers) names.push_back(name + ".yaml");
  return names;
}

void write_results(ResultFolder& folder, const Arguments& arguments,
                   const std::vector<TuningResult>& results) {
  ordered_json json = {{"version", kVersion}, {"budget", arguments.options.budget}};
  for (const TuningResult& result : results) {
    folder.write(result.controller + ".yaml", tuned_yaml(result));
    json["controllers"].push_back(json_of(result));
  }
  folder.write("tuning.json", json_text(json, 2));
  folder.publish();
}

int run(const Arguments& arguments) {
  for (const std::string& name : arguments.controllers) servo::find_controller(name);
  refuse_repeats("tune", arguments.controllers);
  std::optional<ResultFolder> folder;
  if (arguments.out) folder.emplace(*arguments.out, results_of(arguments));
  watch_for_interrupt();
  std::vector<TuningResult> results;
  for (const std::string& name : arguments.controllers) {
    StudyProgress progress("tune " + name, "points");
    auto result = tune(name, arguments.options, [&](std::size_t done) {
      progress.show(done, static_cast<std::size_t>(arguments.options.budget));
      return !interrupted();
    });
    progress.clear();
    if (!result) {
      fmt::print(stderr, "lineservo: tune was broken off in {}; nothing is written\n", name);
      return kFailed;
    }
    fmt::print("{}", text_of(*result));
    results.push_back(std::move(*result));
  }
  if (folder) write_results(*folder, arguments, results);
  if (arguments.out) fmt::print("written to {}\n", *arguments.out);
  return kDone;
}

}  // namespace

void add_tune_command(CLI::App& app, int& exit_code) {
  const auto arguments = std::make_shared<Arguments>();
  Arguments& a = *arguments;
  CLI::App* command = app.add_subcommand("tune", "search the parameters of laws, each with the same budget");
  command->add_option("CONTROLLER", a.controllers, "the laws to tune")->required();
  add_whole_option(*command, "--budget", a.options.budget, 1, 100000,
                   "points, each flown by all training flights");
  add_whole_option(*command, "--jobs", a.options.jobs, 1, kMostJobs,
                   "flights at a time, as many as cores if not given");
  command->add_option("--out", a.out, "folder for CONTROLLER.yaml of each, and tuning.json");
  command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace lineservo::apps
