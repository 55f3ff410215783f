#include "apps/output/flight_folder.h"

#include <fmt/format.h>

#include <map>

#include "apps/config/conditions_range.h"
#include "apps/config/data_folder.h"
#include "apps/config/input_error.h"
#include "apps/config/layout_bitmap.h"
#include "apps/config/mission_file.h"
#include "apps/config/text_file.h"
#include "apps/output/flight_tables.h"
#include "apps/output/json_text.h"
#include "apps/output/report_file.h"
#include "apps/report/flight_data.h"

namespace lineservo::apps {

namespace fs = std::filesystem;

namespace {

std::optional<std::string> own_text(DataKind kind, const std::string& name_or_path) {
  if (is_shipped(kind, name_or_path)) return std::nullopt;
  if (kind == DataKind::conditions && conditions_range(name_or_path))
    return std::nullopt;  // drawn: in the config
  return read_text_file(find_data(kind, name_or_path));
}

/// Writes a file of the user's own and refers to it; without one, an earlier flight's goes.
void keep(ResultFolder& folder, const std::string& name, const std::optional<std::string>& text,
          std::string& reference) {
  if (!text) return folder.leave_out(name);
  folder.write(name, *text);
  reference = name;
}

/// The bitmap of a layout of the user's own.
std::optional<OwnFiles::Image> own_bitmap(const std::string& layout) {
  if (is_shipped(DataKind::layout, layout)) return std::nullopt;
  const auto file = bitmap_file(find_data(DataKind::layout, layout));
  if (!file) return std::nullopt;
  return OwnFiles::Image{file->filename(), read_bytes(*file)};
}

/// The bitmap of the floor of the flight whose results are there.
std::optional<std::string> earlier_bitmap(const fs::path& folder) try {
  const fs::path layout = folder / "layout.yaml";
  std::error_code error;
  if (!fs::is_regular_file(folder / "summary.json", error) || !fs::is_regular_file(layout, error))
    return std::nullopt;
  const auto file = bitmap_file(layout);
  return file ? std::optional(file->filename().string()) : std::nullopt;
} catch (const InputError&) {  // a layout that was changed since, and names none that can be told
  return std::nullopt;
}

/// Writes the bitmap of a floor of the user's own; that of the earlier flight's floor goes.
void keep_bitmap(ResultFolder& folder, const std::optional<OwnFiles::Image>& bitmap) {
  const std::optional<std::string> earlier = earlier_bitmap(folder.path());
  if (earlier && (!bitmap || bitmap->name != *earlier)) folder.leave_out(*earlier);
  if (bitmap) folder.write(bitmap->name, bitmap->bytes);
}

}  // namespace

const std::vector<std::string>& flight_files() {
  static const std::vector<std::string> kFiles = {
      "mission.yaml", "layout.yaml", "conditions.yaml", "flight.csv", "events.csv",
      "config.yaml",  "report.html", "flight.mp4",      "flight.avi", "summary.json"};
  return kFiles;
}

OwnFiles own_files(const FlightRequest& request) {
  const bool is_mission = is_mission_file(request.instruction);
  return {is_mission ? own_text(DataKind::mission, request.instruction) : std::nullopt,
          own_text(DataKind::layout, request.layout), own_text(DataKind::conditions, request.conditions),
          own_bitmap(request.layout)};
}

bool write_flight_report(ResultFolder& folder, const Mission& mission, const FlownMission& flown,
                         const FilmStrip& film) {
  const FlightRequest& request = mission.request;
  return write_report(folder, fmt::format("{} · {} · lineservo", request.instruction, request.controller),
                      [&] { return flight_data(mission, flown.record, flown.summary, film.thumbnails()); });
}

void keep_what_is_no_flights(const fs::path& folder, const OwnFiles& own) {
  std::error_code error;
  if (fs::exists(folder / "config.yaml", error)) return;  // of an earlier flight, so are the others
  const auto keep_other = [&folder](const std::string& name, const std::optional<std::string>& text) {
    std::error_code ignored;
    if (!fs::is_regular_file(folder / name, ignored) || (text && read_bytes(folder / name) == *text)) return;
    throw InputError(
        fmt::format("--out {}: holds a {} that is of no earlier flight, which this one would replace",
                    folder.string(), name));
  };
  const std::map<std::string, std::optional<std::string>> same = {
      {"mission.yaml", own.mission}, {"layout.yaml", own.layout}, {"conditions.yaml", own.conditions}};
  for (const std::string& name : flight_files())
    keep_other(name, same.contains(name) ? same.at(name) : std::nullopt);
  for (const char* recorded : {"recording.csv", "recording.json"}) keep_other(recorded, std::nullopt);
  if (own.bitmap) keep_other(own.bitmap->name, own.bitmap->bytes);
}

void write_flight(ResultFolder& folder, const Mission& mission, const OwnFiles& own,
                  const FlownMission& flown, const FilmStrip& film) {
  FlightRequest kept = mission.request;
  keep(folder, "mission.yaml", own.mission, kept.instruction);
  keep(folder, "layout.yaml", own.layout, kept.layout);
  keep_bitmap(folder, own.bitmap);
  keep(folder, "conditions.yaml", own.conditions, kept.conditions);
  folder.write("flight.csv", flight_csv(flown.record));
  folder.write("events.csv", events_csv(flown.record));
  folder.write("config.yaml", config_text(kept));
  write_flight_report(folder, mission, flown, film);
  folder.write("summary.json", json_text(to_json(mission.request, flown.summary), 2));
  folder.publish();
}

}  // namespace lineservo::apps
