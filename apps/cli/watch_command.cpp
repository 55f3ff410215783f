#include "apps/cli/watch_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "apps/cli/interrupt.h"
#include "apps/cli/list_option.h"
#include "apps/cli/number_option.h"
#include "apps/cli/program.h"
#include "apps/overlay/watch_scene.h"
#include "apps/view/live_view.h"
#include "apps/watch/open_watch.h"
#include "apps/watch/watch.h"
#include "apps/watch/watch_results.h"
#include "apps/watch/watch_table.h"

namespace lineservo::apps {
namespace {

constexpr int kMostFrames = 1'000'000'000;

struct WatchArguments {
  WatchRequest request;
  std::optional<std::string> out, record;
  int frames = kMostFrames;
  bool view = false;
};

/// What was got is kept, however it ended. Ctrl-C is how watching a camera ends; files end by themselves.
int told(const WatchEnd& end, const WatchFeed& feed) {
  std::fflush(stdout);
  if (!end.broke_off.empty())
    fmt::print(stderr, "lineservo: watch: {}; watched {} frames until then\n", end.broke_off, end.frames);
  if (end.interrupted) fmt::print(stderr, "lineservo: watch: interrupted after {} frames\n", end.frames);
  const bool is_done = end.broke_off.empty() && (!end.interrupted || feed.is_live());
  return is_done ? kDone : kFailed;
}

std::unique_ptr<LiveView> view_of(const OpenWatch& opened, const std::string& source) {
  std::string complaint;
  auto view = open_live_view(
      watch_overlay(opened, source, View::keys()), "lineservo watch " + source, [] { return !interrupted(); },
      complaint);
  if (!view) fmt::print(stderr, "lineservo: watch: --view: {}; goes on without\n", complaint);
  return view;
}

void show(LiveView& view, const Watched& watched) {
  view.show(scene_of(watched), watched.tick.input);
  if (const auto news = view.take_news()) fmt::print(stderr, "lineservo: watch: {}\n", *news);
}

int run_watch(const WatchArguments& arguments) {
  OpenWatch opened = open_watch(arguments.request);
  WatchChains chains(opened.feed->camera(), opened.request.settings, opened.controllers);
  watch_for_interrupt();
  WatchResults results(arguments.out, arguments.record, arguments.request, opened);
  const bool prints = !arguments.out;
  WatchOptions options;
  options.frames = arguments.frames;
  const auto view = arguments.view ? view_of(opened, arguments.request.source) : nullptr;
  options.goes_on = [&view] { return !interrupted() && !(view && view->wants_end()); };
  if (prints) fmt::print("{}", watch_header(opened.controllers));
  const WatchEnd end = watch(*opened.feed, chains, options, [&](const Watched& watched) {
    const std::string row = results.add(watched);
    if (prints) fmt::print("{}", row);
    if (prints && opened.feed->is_live()) std::fflush(stdout);
    if (view) show(*view, watched);
  });
  results.publish();
  return told(end, *opened.feed);
}

}  // namespace

void add_watch_command(CLI::App& app, int& exit_code) {
  const auto arguments = std::make_shared<WatchArguments>();
  WatchRequest& request = arguments->request;
  CLI::App* command = app.add_subcommand(
      "watch",
      "what perception sees in a camera, a video, images or a recording, and what laws would command");
  command
      ->add_option(
          "SOURCE", request.source,
          "a V4L2 device (/dev/video0, or 0), a video file, a numbered sequence (f%04d.png), a folder "
          "of images, a URL (rtsp://...), a GStreamer pipeline ending in appsink, the folder of a "
          "recording, or a simulated flight (sim:warehouse/a13)")
      ->required();
  add_list_option(
      *command, "--controllers,--controller", request.controllers,
      "the laws whose commands are printed (default ibvs, or those of the recording); what is seen "
      "is printed as the first one's perception has it");
  command->add_option("--camera", request.camera,
                      "camera file, as of detect (default: camera.* of the settings, 640 by 480 px)");
  command->add_flag("--scale-camera", request.scale_camera,
                    "scale the camera to frames of another size that show the same view");
  command->add_option(
      "--height", request.height,
      "of the camera in metres (default 0.5), or a CSV file with t_s, height_m and, as far as "
      "known, roll_rad, pitch_rad, yaw_rad, forward_m_s, left_m_s, up_m_s");
  command->add_option("--rate", request.rate, "frames a second of images, and asked of devices (default 30)");
  command->add_option("--speed", request.speed,
                      "that the laws follow with, m/s (default that of the conditions)");
  command->add_option("--conditions", request.conditions, "whose settings hold, as of fly (default paper)");
  command->add_option("--seed", request.seed, "of a simulated flight (default 1)");
  command
      ->add_option_function<std::string>(
          "--set", [&request](const std::string& assignment) { request.overrides.push_back(assignment); },
          "KEY=VALUE: any setting of config.yaml; may be repeated")
      ->trigger_on_parse();
  add_whole_option(*command, "--frames", arguments->frames, 1, kMostFrames, "how many frames to watch");
  command->add_option("--out", arguments->out, "CSV file, in the place of standard output");
  command->add_option("--record", arguments->record,
                      "folder that keeps the frames, estimates and commands, for replay");
  command->add_flag("--view", arguments->view,
                    "show the frames, what is seen and commanded, and plots in windows, in real time; "
                    "space pauses, n steps, f goes as fast as it can, q quits");
  command->callback([arguments, &exit_code] { exit_code = run_watch(*arguments); });
}

}  // namespace lineservo::apps
