#include "apps/cli/fly_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>

#include "apps/cli/flight_printer.h"
#include "apps/cli/interrupt.h"
#include "apps/cli/onlookers.h"
#include "apps/cli/program.h"
#include "apps/config/flight_request.h"
#include "apps/config/input_error.h"
#include "apps/config/settings_table.h"
#include "apps/config/tuned_settings.h"
#include "apps/flight/mission.h"
#include "apps/output/flight_folder.h"
#include "apps/output/flight_summary.h"
#include "apps/output/json_text.h"
#include "apps/output/result_folder.h"
#include "apps/output/result_kind.h"

namespace lineservo::apps {
namespace {

/// As typed; what was not typed keeps the value of --config or the default.
struct FlyArguments {
  std::string target;
  std::optional<std::string> controller, layout, conditions, config, out, seed, speed;
  std::vector<std::string> overrides;
  bool land = false, tuned = false, explain = false, json = false;
  Looks looks;
};

void refuse_two_speeds(const FlyArguments& a) {
  for (const std::string& assignment : a.overrides) {
    if (a.speed && assignment.starts_with("speed_m_s="))
      throw InputError("fly: --speed and --set speed_m_s both give the speed; only one of them is allowed");
  }
}

FlightRequest request_of(const FlyArguments& a) {
  if (a.config && a.conditions)
    throw InputError(
        "fly: --config holds every setting, so --conditions cannot go with it; use --set KEY=VALUE");
  refuse_two_speeds(a);
  FlightRequest request = a.config ? read_config(*a.config) : FlightRequest{};
  if (a.seed) request.seed = read_seed(*a.seed, fmt::format("--seed {}", *a.seed));  // it may draw conditions
  if (!a.config) apply_conditions(request, a.conditions.value_or(request.conditions));
  if (!a.target.empty()) request.instruction = a.target;
  if (a.controller) request.controller = *a.controller;
  if (!a.config) request.layout = layout_of_zone(request.instruction);
  if (a.layout) request.layout = *a.layout;
  if (a.tuned) apply_shipped_tuned(request, "--tuned");
  if (a.land) request.land = true;
  if (a.speed) SettingsTable(request.settings).set("speed_m_s", *a.speed, "--speed");
  for (const std::string& assignment : a.overrides) apply_override(request, assignment);
  if (request.instruction.empty())
    throw InputError(
        "fly: TARGET is missing: an instruction such as a13, node:NAME, or a mission file (*.yaml)");
  return request;
}

int fly(const FlyArguments& arguments) {
  const Mission mission = prepare(request_of(arguments));
  const FlightRequest& request = mission.request;
  if (arguments.explain) {
    print_plan(mission.plan);
    return kDone;
  }
  const OwnFiles own = own_files(request);
  watch_for_interrupt();
  std::optional<ResultFolder> folder;
  if (arguments.out) {
    refuse_other_kinds(*arguments.out, ResultKind::flight, "--out");
    keep_what_is_no_flights(*arguments.out, own);
    folder.emplace(*arguments.out, flight_files());
  }
  Onlookers onlookers(arguments.looks, mission, folder ? &*folder : nullptr);
  ProgressLine line(request.instruction);
  const FlownMission flown = fly_mission(
      mission,
      [&](const FlightProgress& progress) {
        line.show(progress);
        return !interrupted() && !onlookers.want_end();
      },
      onlookers.listener());
  line.clear();
  if (folder) onlookers.write(*folder);
  if (folder) write_flight(*folder, mission, own, flown, onlookers.film());
  if (arguments.json) {
    fmt::print("{}", json_text(to_json(request, flown.summary), 2));
  } else {
    print_summary(request, flown.record, flown.summary);
    if (arguments.out) fmt::print("written to {}\n", *arguments.out);
  }
  return flown.summary.succeeded() ? kDone : kFailed;
}

}  // namespace

void add_fly_command(CLI::App& app, int& exit_code) {
  const auto arguments = std::make_shared<FlyArguments>();
  FlyArguments& a = *arguments;
  CLI::App* command = app.add_subcommand("fly", "fly an instruction or a mission in simulation");
  command->add_option("TARGET", a.target,
                      "an instruction such as a13, node:NAME, or a mission file (*.yaml)");
  command->add_option("--controller", a.controller,
                      "the law that flies (default ibvs; lineservo controllers lists them)");
  command->add_option(
      "--layout", a.layout,
      "a floor that ships, or a YAML file (default that of the zone: warehouse, square, octagon, circle; or "
      "of the mission)");
  command->add_option(
      "--conditions", a.conditions,
      "conditions that ship, a YAML file, or two with .. between: drawn from the seed (default paper)");
  command->add_option("--speed", a.speed, "speed along the line in m/s (default: that of the conditions)");
  command->add_option("--seed", a.seed, "seed of everything random (default 1)");
  command
      ->add_option_function<std::string>(
          "--set", [&a](const std::string& assignment) { a.overrides.push_back(assignment); },
          "KEY=VALUE: any setting of config.yaml; may be repeated")
      ->trigger_on_parse();
  command->add_flag("--tuned", a.tuned,
                    "with the controller's tuned parameters instead of the published ones");
  command->add_option(
      "--config", a.config,
      "the config.yaml of an earlier flight, to repeat it; what else is typed goes before it. It holds "
      "every setting: not together with --conditions");
  command->add_flag("--land", a.land, "land on the target instead of hovering");
  CLI::Option* explain = command->add_flag("--explain", a.explain, "print the plan and do not fly");
  CLI::Option* out = command->add_option("--out", a.out,
                                         "folder for summary.json, flight.csv, events.csv, config.yaml, "
                                         "report.html, and mission.yaml, layout.yaml and "
                                         "conditions.yaml when they are your own");
  command
      ->add_flag("--record", a.looks.record,
                 "keep the frames, estimates and commands in the folder of --out, each with its hash, for "
                 "lineservo replay and watch")
      ->needs(out);
  command
      ->add_flag("--video", a.looks.video,
                 "write flight.mp4 into the folder of --out: what the camera saw, with what was seen and "
                 "commanded and a map, in real time")
      ->needs(out);
  CLI::Option* view = command->add_flag(
      "--view", a.looks.view,
      "show the camera, what is seen and commanded, a map and plots in windows, in real time; "
      "space pauses, n steps, f goes as fast as it can, q quits");
  CLI::Option* json = command->add_flag("--json", a.json, "print summary.json instead of the short report");
  for (CLI::Option* other : {out, view, json}) explain->excludes(other);
  command->callback([arguments, &exit_code] { exit_code = fly(*arguments); });
}

}  // namespace lineservo::apps
