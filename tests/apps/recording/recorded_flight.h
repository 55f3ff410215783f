#pragma once

#include <filesystem>
#include <vector>

#include "apps/flight/mission.h"
#include "apps/output/flight_folder.h"
#include "apps/recording/recorder.h"
#include "apps/recording/recording.h"
#include "tests/apps/flight/test_flight.h"
#include "tests/apps/test_files.h"

namespace lineservo::apps::testing {

/// The first seconds of a flight, small frames: take-off, aligning, and some of the first edge.
inline FlightRequest short_request(const std::vector<std::string>& overrides = {}) {
  FlightRequest request = request_for("a13", "paper");
  for (const char* assignment : {"camera.width_px=320", "camera.height_px=240", "camera.focal_px=160"})
    apply_override(request, assignment);
  for (const std::string& assignment : overrides) apply_override(request, assignment);
  return request;
}

/// Flies for a few seconds and records it, as fly --record does.
inline void record_flight(const std::filesystem::path& folder, const FlightRequest& request) {
  constexpr int kSeconds = 12;
  const Mission mission = prepare(request);
  ResultFolder results(folder);
  RecordingInfo info;
  info.source = request.instruction;
  info.controllers = {request.controller};
  Recorder recorder(results, info);
  const FlownMission flown = fly_mission(
      mission, [](const FlightProgress& progress) { return progress.time_s < kSeconds; },
      [&recorder](const FlightTick& tick) {
        const ChainOutput output{tick.features, tick.command};
        recorder.add(tick.input, tick.bgr, {&output, 1});
      });
  recorder.write();
  write_flight(results, mission, own_files(mission.request), flown, FilmStrip());
}

/// Writes the recording's rows again, as if they had been recorded so.
inline void write_table(const Recording& recording) {
  std::string table = recording_header(recording.info.controllers);
  for (const RecordedTick& tick : recording.ticks) table += recording_row(tick);
  std::ofstream(recording.folder / kRecordingTable, std::ios::binary) << table;
}

}  // namespace lineservo::apps::testing
