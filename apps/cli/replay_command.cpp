#include "apps/cli/replay_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "apps/cli/interrupt.h"
#include "apps/cli/list_option.h"
#include "apps/cli/program.h"
#include "apps/output/command_columns.h"
#include "apps/recording/replay.h"
#include "servo/law/controllers.h"

namespace lineservo::apps {
namespace {

struct ReplayArguments {
  std::string folder;
  std::vector<std::string> controllers;
};

std::string header(const Recording& recording, const std::vector<std::string>& others) {
  std::string text = "t_s,frame";
  for (const std::string& controller : recording.info.controllers)
    text += command_columns("recorded." + controller);
  for (const std::string& controller : others) text += command_columns(controller);
  return text + "\n";
}

std::string row(const ReplayedTick& tick) {
  std::string text = fmt::format("{:.4f},{}", servo::seconds(tick.recorded.input.now), tick.recorded.frame);
  for (const RecordedOutput& output : tick.recorded.outputs) text += command_cells(output.command);
  for (const servo::Command& command : tick.others) text += command_cells(row_of(command));
  return text + "\n";
}

int run_replay(const ReplayArguments& arguments) {
  const Recording recording = read_recording(arguments.folder);
  const bool prints = !arguments.controllers.empty();
  std::size_t ticks = 0;
  ReplayOptions options;
  options.others = arguments.controllers;
  options.on_tick = [&](const ReplayedTick& tick) {
    if (prints && ticks == 0) fmt::print("{}", header(recording, arguments.controllers));
    if (prints) fmt::print("{}", row(tick));
    ++ticks;
    return !interrupted();
  };
  watch_for_interrupt();
  const std::optional<std::string> difference = replay(recording, options);
  if (difference) {
    std::fflush(stdout);
    fmt::print(stderr, "lineservo: replay: {}: {}\n", arguments.folder, *difference);
    return kFailed;
  }
  if (ticks < recording.ticks.size()) {
    fmt::print(stderr, "lineservo: replay: interrupted; the same so far, after {} of {} ticks\n", ticks,
               recording.ticks.size());
    return kFailed;
  }
  if (!prints)
    fmt::print("{}: {} ticks, {} frames: the same features and commands to the last bit\n", arguments.folder,
               ticks, recording.info.frames);
  return kDone;
}

}  // namespace

void add_replay_command(CLI::App& app, int& exit_code) {
  const auto arguments = std::make_shared<ReplayArguments>();
  CLI::App* command = app.add_subcommand(
      "replay", "run perception and control again on a recording; exit code 1 on any difference");
  command->add_option("DIR", arguments->folder, "a folder of fly --record --out DIR or watch --record DIR")
      ->required();
  add_list_option(*command, "--controllers,--controller", arguments->controllers,
                  "print as CSV what these laws say on the same frames and estimates, beside what was "
                  "recorded; their commands move nothing");
  command->callback([arguments, &exit_code] { exit_code = run_replay(*arguments); });
}

}  // namespace lineservo::apps
