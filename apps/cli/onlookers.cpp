#include "apps/cli/onlookers.h"

#include <fmt/format.h>

#include <cstdio>

#include "apps/cli/interrupt.h"
#include "apps/overlay/flight_scene.h"

namespace lineservo::apps {
namespace {

void say(const std::string& news) {
  fmt::print(stderr, "lineservo: fly: {}\n", news);
}

RecordingInfo recording_of(const FlightRequest& request) {
  RecordingInfo info;
  info.source = request.instruction;
  info.controllers = {request.controller};
  return info;
}

std::unique_ptr<LiveView> view_of(const Mission& mission) {
  std::string complaint;
  auto view = open_live_view(
      flight_overlay(mission, View::keys()), "lineservo fly " + mission.request.instruction,
      [] { return !interrupted(); }, complaint);
  if (!view) say(fmt::format("--view: {}; goes on without", complaint));
  return view;
}

}  // namespace

Onlookers::Onlookers(const Looks& looks, const Mission& mission, ResultFolder* folder)
    : films_(folder != nullptr) {
  if (looks.record) recorder_.emplace(*folder, recording_of(mission.request));
  if (looks.video) video_.emplace(*folder, mission);
  if (video_ && !video_->note().empty()) say(video_->note());
  if (looks.view) view_ = view_of(mission);
}

TickListener Onlookers::listener() {
  if (!films_ && !recorder_ && !video_ && !view_) return {};
  return [this](const FlightTick& tick) { see(tick); };
}

void Onlookers::see(const FlightTick& tick) {
  if (films_) film_.add(tick);
  const ChainOutput output{tick.features, tick.command};
  if (recorder_) recorder_->add(tick.input, tick.bgr, {&output, 1});
  if (video_) video_->add(tick);
  if (!view_) return;
  view_->show(scene_of(tick), tick.input);
  if (const auto news = view_->take_news()) say(*news);
}

void Onlookers::write(ResultFolder& folder) {
  if (recorder_) {
    recorder_->write();
  } else {
    leave_out_recording(folder);
  }
  if (video_) {
    video_->write();
  } else {
    leave_out_video(folder);
  }
}

}  // namespace lineservo::apps
