#include "apps/cli/report_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "apps/cli/program.h"
#include "apps/config/input_error.h"
#include "apps/config/text_file.h"
#include "apps/flight/mission.h"
#include "apps/output/flight_folder.h"
#include "apps/output/report_file.h"
#include "apps/output/result_folder.h"

namespace lineservo::apps {
namespace {

namespace fs = std::filesystem;

/// The hash of the flight whose files lie in the folder.
std::string recorded_hash(const fs::path& folder) {
  const fs::path file = folder / "summary.json";
  const auto json = nlohmann::json::parse(read_text_file(file), nullptr, /*allow_exceptions=*/false);
  if (json.is_object() && json.contains("trajectory_sha256") && json["trajectory_sha256"].is_string())
    return json["trajectory_sha256"];
  throw InputError(
      fmt::format("{}: is not the summary of a flight: it has no trajectory_sha256", file.string()));
}

/// Flies the flight again: only its own trajectory is reported as it.
int report(const std::string& name) {
  const fs::path folder = name;
  const std::string hash = recorded_hash(folder);
  const Mission mission = prepare(read_config(folder / "config.yaml"));
  const auto [record, summary] = fly_mission(mission);
  if (summary.trajectory_sha256 != hash) {
    fmt::print(
        stderr,
        "lineservo: {}: config.yaml flies otherwise than summary.json says (broken off, or not its own)\n",
        name);
    return kFailed;
  }
  ResultFolder results(folder, {kReportFile});
  if (!write_flight_report(results, mission, record, summary)) return kFailed;
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
