#include "apps/evaluate/fault_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "apps/compare/statistics.h"
#include "apps/version.h"

namespace lineservo::apps {
namespace {

using nlohmann::ordered_json;

std::map<std::string, long> outcomes(const FaultRow& row) {
  std::map<std::string, long> counts;
  for (const FaultFlight& flight : row.flights) ++counts[flight.outcome];
  return counts;
}

std::string outcomes_text(const FaultRow& row) {
  std::string text;
  for (const auto& [outcome, count] : outcomes(row))
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, outcome);
  return text;
}

double furthest_m(const FaultRow& row) {
  double most_m = 0.0;
  for (const FaultFlight& flight : row.flights) most_m = std::max(most_m, flight.safety.paint_distance_m);
  return most_m;
}

Interval safe_ci95(const FaultRow& row) {
  return wilson95(safe_endings(row), static_cast<long>(row.flights.size()));
}

std::string quoted(const std::string& text) {
  std::string doubled;
  for (const char c : text) doubled.append(c == '"' ? 2 : 1, c);
  return fmt::format("\"{}\"", doubled);
}

ordered_json json_of(const FaultFlight& f) {
  return {{"instruction", f.instruction},
          {"seed", f.seed},
          {"outcome", f.outcome},
          {"reason", f.safety.reason},
          {"ends", f.safety.ends},
          {"safe", f.safety.is_safe()},
          {"paint_distance_m", f.safety.paint_distance_m},
          {"command", f.command}};
}

}  // namespace

long safe_endings(const FaultRow& row) {
  return std::count_if(row.flights.begin(), row.flights.end(),
                       [](const FaultFlight& flight) { return flight.safety.is_safe(); });
}

bool all_safe(const std::vector<FaultRow>& rows) {
  return std::all_of(rows.begin(), rows.end(), [](const FaultRow& row) {
    return safe_endings(row) == static_cast<long>(row.flights.size());
  });
}

std::string fault_table(const std::vector<FaultRow>& rows) {
  std::string text =
      fmt::format("{:<26}{:>14}{:>9}{:>10}   {}\n", "fault", "safe endings", "95 %", "far off m", "outcomes");
  std::string unsafe;
  for (const FaultRow& row : rows) {
    const Interval ci = safe_ci95(row);
    text += fmt::format("{:<26}{:>6} of {:<4}{:>5.0f}-{:<3.0f}{:>9.2f}   {}\n", row.name, safe_endings(row),
                        row.flights.size(), 100 * ci.low, 100 * ci.high, furthest_m(row), outcomes_text(row));
    for (const FaultFlight& f : row.flights) {
      if (!f.safety.is_safe())
        unsafe += fmt::format("  {} {:.2f} m  {}\n", f.safety.ends, f.safety.paint_distance_m, f.command);
    }
  }
  return text + (unsafe.empty() ? "\nevery flight ended safely\n" : "\nnot safe:\n" + unsafe);
}

ordered_json fault_json(const FaultStudyOptions& options, const std::vector<FaultRow>& rows) {
  ordered_json json = {{"kind", "faults"},
                       {"version", kVersion},
                       {"controller", options.controller},
                       {"conditions", options.conditions},
                       {"instructions", options.instructions},
                       {"runs", options.runs},
                       {"seed", options.seed},
                       {"set", options.overrides},
                       {"corridor_m", kCorridor_m}};
  json["faults"] = ordered_json::array();
  for (const FaultRow& row : rows) {
    const Interval ci = safe_ci95(row);
    ordered_json one = {{"fault", row.name},
                        {"runs", row.flights.size()},
                        {"safe", safe_endings(row)},
                        {"safe_ci95", {ci.low, ci.high}},
                        {"paint_distance_max_m", furthest_m(row)},
                        {"outcomes", outcomes(row)}};
    one["flights"] = ordered_json::array();
    for (const FaultFlight& flight : row.flights) one["flights"].push_back(json_of(flight));
    json["faults"].push_back(std::move(one));
  }
  return json;
}

std::string fault_csv(const std::vector<FaultRow>& rows) {
  std::string csv = "fault,instruction,seed,outcome,reason,ends,safe,paint_distance_m,command\n";
  for (const FaultRow& row : rows) {
    for (const FaultFlight& f : row.flights) {
      csv += fmt::format("{},{},{},{},{},{},{},{:.4f},{}\n", row.name, f.instruction, f.seed, f.outcome,
                         quoted(f.safety.reason), f.safety.ends, f.safety.is_safe(),
                         f.safety.paint_distance_m, quoted(f.command));
    }
  }
  return csv;
}

}  // namespace lineservo::apps
