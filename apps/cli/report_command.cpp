#include "apps/cli/report_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "apps/cli/interrupt.h"
#include "apps/cli/program.h"
#include "apps/config/conditions_range.h"
#include "apps/config/data_folder.h"
#include "apps/config/input_error.h"
#include "apps/config/mission_file.h"
#include "apps/config/text_file.h"
#include "apps/flight/mission.h"
#include "apps/output/flight_folder.h"
#include "apps/output/flight_tables.h"
#include "apps/output/json_text.h"
#include "apps/output/report_file.h"
#include "apps/output/result_folder.h"

namespace lineservo::apps {
namespace {

namespace fs = std::filesystem;

constexpr const char* kHash = "trajectory_sha256";

using nlohmann::json;

/// The summary of the flight whose files lie in the folder.
json recorded_summary(const fs::path& folder) {
  const fs::path file = folder / "summary.json";
  json summary = json::parse(read_text_file(file), nullptr, /*allow_exceptions=*/false);
  if (summary.is_object() && summary.contains(kHash) && summary[kHash].is_string()) return summary;
  throw InputError(fmt::format("{}: is not the summary of a flight: it has no {}", file.string(), kHash));
}

/// The user's own files have other names in the folder than where they were flown from.
void hide_own_name(json& summary, const char* key, bool is_own) {
  if (summary.contains(key) && is_own) summary[key] = "a file of one's own";
}

std::string text(const json& summary, const char* key) {
  return summary.contains(key) && summary[key].is_string() ? summary[key].get<std::string>() : "";
}

/// What two summaries of one flight have in common.
json without_circumstances(json summary) {
  summary.erase("timing");
  const std::string instruction = text(summary, "instruction"), conditions = text(summary, "conditions");
  hide_own_name(summary, "instruction",
                is_mission_file(instruction) && !is_shipped(DataKind::mission, instruction));
  hide_own_name(summary, "layout", !is_shipped(DataKind::layout, text(summary, "layout")));
  hide_own_name(summary, "conditions",
                !conditions_range(conditions) && !is_shipped(DataKind::conditions, conditions));
  return summary;
}

/// The first value in which the summary that is there differs from that of the flight flown again.
std::optional<std::string> difference(const json& there, const json& flown) {
  if (there[kHash] != flown[kHash])
    return "config.yaml flies otherwise than summary.json says (broken off, or not its own)";
  const json changes = json::diff(without_circumstances(there), without_circumstances(flown));
  if (changes.empty()) return std::nullopt;
  const json& first = changes.front();
  const std::string path = first["path"];
  const json::json_pointer place(path);
  return fmt::format("summary.json is not of the flight of config.yaml: {} is {}, flown again {}",
                     path.substr(1), there.contains(place) ? there[place].dump() : "nothing",
                     first.contains("value") ? first["value"].dump() : "nothing");
}

bool is_table_of(const fs::path& file, const FlightRecord& record) {
  return read_bytes(file) == flight_csv(record);
}

/// Flies the flight again: only the one that summary.json tells of is reported as it.
int report(const std::string& name) {
  const fs::path folder = name;
  const json there = recorded_summary(folder);
  const Mission mission = prepare(read_config(folder / "config.yaml"));
  end_on_interrupt("report");
  FilmStrip film;
  const FlownMission flown = fly_mission(mission, {}, [&film](const FlightTick& tick) { film.add(tick); });
  if (const auto why = difference(there, json::parse(json_text(to_json(mission.request, flown.summary))))) {
    fmt::print(stderr, "lineservo: {}: {}\n", name, *why);
    return kFailed;
  }
  if (!is_table_of(folder / "flight.csv", flown.record)) {
    fmt::print(stderr, "lineservo: {}: flight.csv is not that of the flight of config.yaml\n", name);
    return kFailed;
  }
  watch_for_interrupt();  // the report, once begun, is written whole
  ResultFolder results(folder, {kReportFile});
  if (!write_flight_report(results, mission, flown, film)) return kFailed;
  results.publish();
  fmt::print("written to {}\n", (folder / kReportFile).string());
  return kDone;
}

}  // namespace

void add_report_command(CLI::App& app, int& exit_code) {
  const auto folder = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("report", "write report.html into the folder of an earlier flight");
  command->add_option("DIR", *folder, "a folder that fly --out wrote")->required();
  command->callback([folder, &exit_code] { exit_code = report(*folder); });
}

}  // namespace lineservo::apps
