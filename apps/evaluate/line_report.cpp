#include "apps/evaluate/line_report.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "apps/version.h"

namespace lineservo::apps {
namespace {

using nlohmann::ordered_json;

// grid Tab. II: mean errors on about 50 pictures of 1920×1080, simulated and real, truth drawn by hand; and
// Tab. I: frames a second on an i7, whole pipeline.
struct Published {
  double simulated_px, simulated_deg, real_px, real_deg;
  std::optional<double> frames_per_s;
};

std::optional<Published> published(const std::string& method) {
  if (method == "naive") return Published{56, 3, 78, 12, std::nullopt};
  if (method == "slices") return Published{10, 3, 18, 5, 15.1};
  if (method == "skeleton") return Published{5, 4, 15, 10, 20.0};
  if (method == "combined") return Published{6, 3, 16, 7, std::nullopt};
  return std::nullopt;
}

ordered_json number(double value) {
  return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

ordered_json json_of(const ErrorSummary& errors) {
  return {{"mean", number(errors.mean)}, {"median", number(errors.median)}, {"p95", number(errors.p95)}};
}

ordered_json json_of(const ShareInterval& interval) {
  return {number(interval.low), number(interval.high)};
}

ShareInterval detection_ci95(const LineScore& score) {
  return wilson_interval(score.found, score.frames_with_line);
}

ShareInterval false_alarm_ci95(const LineScore& score) {
  return wilson_interval(score.false_alarms, score.frames_without_line);
}

ordered_json json_of(const Published& p) {
  ordered_json json = {{"simulated_rho_px", p.simulated_px},
                       {"simulated_theta_deg", p.simulated_deg},
                       {"real_rho_px", p.real_px},
                       {"real_theta_deg", p.real_deg}};
  json["frames_per_s"] = p.frames_per_s ? ordered_json(*p.frames_per_s) : ordered_json(nullptr);
  return json;
}

ordered_json json_of(const LineEvaluationRow& row) {
  const auto beside = published(row.method);
  ordered_json json = {{"method", row.method},
                       {"told_tilt", row.told_tilt},
                       {"level", name_of(row.level)},
                       {"width", row.size.width},
                       {"height", row.size.height},
                       {"frames_with_line", row.score.frames_with_line},
                       {"frames_without_line", row.score.frames_without_line},
                       {"answered", row.score.answered},
                       {"detection_rate", number(row.score.detection_rate())},
                       {"detection_ci95", json_of(detection_ci95(row.score))},
                       {"false_alarm_rate", number(row.score.false_alarm_rate())},
                       {"false_alarm_ci95", json_of(false_alarm_ci95(row.score))},
                       {"rho_error_px", json_of(summarise_errors(row.score.rho_px))},
                       {"theta_error_deg", json_of(summarise_errors(row.score.theta_deg))},
                       {"mask_ms", number(row.score.mask_per_frame_ms())},
                       {"line_ms", number(row.score.time_per_frame_ms())}};
  json["published"] = beside ? json_of(*beside) : ordered_json(nullptr);
  return json;
}

std::string plain(double value) {
  return std::isfinite(value) ? fmt::format("{:.6g}", value) : "";
}

// NaN is "-" in the table.
std::string cell(double value, int width, int digits) {
  return std::isfinite(value) ? fmt::format("{:>{}.{}f}", value, width, digits)
                              : fmt::format("{:>{}}", "-", width);
}

// A share and its interval, in per cent.
std::string share_cell(double share, const ShareInterval& ci95) {
  if (!std::isfinite(share)) return fmt::format("{:>18}", "-");
  return fmt::format("{:>6.1f} {:>11}", 100.0 * share,
                     fmt::format("{:.1f}…{:.1f}", 100.0 * ci95.low, 100.0 * ci95.high));
}

std::string published_cell(const LineEvaluationRow& row) {
  const auto beside = published(row.method);
  if (!beside || row.size.width != 1920) return "";
  if (row.level == FrameLevel::clean)
    return fmt::format("{:g} px {:g}° (simulated)", beside->simulated_px, beside->simulated_deg);
  if (row.level == FrameLevel::real_like)
    return fmt::format("{:g} px {:g}° (real)", beside->real_px, beside->real_deg);
  return "";
}

std::string table_row(const LineEvaluationRow& row) {
  const ErrorSummary rho = summarise_errors(row.score.rho_px), theta = summarise_errors(row.score.theta_deg);
  const std::string name = row.method + (row.told_tilt ? " +tilt" : "");
  return fmt::format("{:<15}{}{}{} {}{}{} {}{}{}{}  {}\n", name, cell(rho.mean, 8, 2), cell(rho.median, 8, 2),
                     cell(rho.p95, 8, 2), cell(theta.mean, 8, 3), cell(theta.median, 8, 3),
                     cell(theta.p95, 8, 3), share_cell(row.score.detection_rate(), detection_ci95(row.score)),
                     share_cell(row.score.false_alarm_rate(), false_alarm_ci95(row.score)),
                     cell(row.score.mask_per_frame_ms(), 8, 2), cell(row.score.time_per_frame_ms(), 8, 2),
                     published_cell(row));
}

std::string heading(const LineEvaluationRow& row) {
  return fmt::format(
      "\n{}×{}, {}: {} frames with a line, {} without\n"
      "{:<15}{:>8}{:>8}{:>8} {:>8}{:>8}{:>8} {:>18}{:>18}{:>8}{:>8}  {}\n",
      row.size.width, row.size.height, name_of(row.level), row.score.frames_with_line,
      row.score.frames_without_line, "method", "Δρ mean", "median", "p95 px", "Δθ mean", "median", "p95 °",
      "found % (95 %)", "false % (95 %)", "mask ms", "line ms", "published mean");
}

}  // namespace

ordered_json lines_json(const LineEvaluationOptions& options, const std::vector<LineEvaluationRow>& rows) {
  ordered_json json;
  json["evaluation"] = "lines";
  json["version"] = std::string(kVersion);
  json["settings"] = {{"frames", options.frames},
                      {"seed", options.seed},
                      {"empty_share", options.empty_share},
                      {"found_within_px", kFoundWithin_px},
                      {"found_within_deg", kFoundWithin_deg}};
  json["rows"] = ordered_json::array();
  for (const LineEvaluationRow& row : rows) json["rows"].push_back(json_of(row));
  return json;
}

std::string lines_csv(const std::vector<LineEvaluationRow>& rows) {
  std::string csv =
      "method,told_tilt,level,width_px,height_px,frames_with_line,frames_without_line,rho_mean_px,rho_median_"
      "px,"
      "rho_p95_px,theta_mean_deg,theta_median_deg,theta_p95_deg,detection_rate,detection_low,detection_high,"
      "false_alarm_rate,false_alarm_low,false_alarm_high,mask_ms,line_ms\n";
  for (const LineEvaluationRow& row : rows) {
    const LineScore& s = row.score;
    const ErrorSummary rho = summarise_errors(s.rho_px), theta = summarise_errors(s.theta_deg);
    const ShareInterval found = detection_ci95(s), alarms = false_alarm_ci95(s);
    csv += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", row.method,
                       int{row.told_tilt}, name_of(row.level), row.size.width, row.size.height,
                       s.frames_with_line, s.frames_without_line, plain(rho.mean), plain(rho.median),
                       plain(rho.p95), plain(theta.mean), plain(theta.median), plain(theta.p95),
                       plain(s.detection_rate()), plain(found.low), plain(found.high),
                       plain(s.false_alarm_rate()), plain(alarms.low), plain(alarms.high),
                       plain(s.mask_per_frame_ms()), plain(s.time_per_frame_ms()));
  }
  return csv;
}

std::string lines_table(const std::vector<LineEvaluationRow>& rows) {
  std::string table;
  const LineEvaluationRow* last = nullptr;
  for (const LineEvaluationRow& row : rows) {
    if (!last || last->level != row.level || last->size != row.size) table += heading(row);
    table += table_row(row);
    last = &row;
  }
  return table;
}

}  // namespace lineservo::apps
