#include "apps/compare/comparison_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "apps/compare/metrics.h"
#include "apps/compare/published.h"

namespace lineservo::apps {
namespace {

constexpr std::size_t kCommandsShown = 10;

/// Nothing to tell is "-".
std::string cell(double value, int width, int digits) {
  return std::isfinite(value) ? fmt::format("{:>{}.{}f}", value, width, digits)
                              : fmt::format("{:>{}}", "-", width);
}
std::string cell_cm(double value_m, int width = 8) {
  return cell(100.0 * value_m, width, 2);
}
std::string cell_cm(const std::optional<double>& value_m, int width = 8) {
  return cell_cm(value_m.value_or(std::nan("")), width);
}

std::string speed_text(const Entry& e) {
  return std::isnan(e.speed_m_s) ? "speeds drawn" : fmt::format("{:.4g} m/s", e.speed_m_s);
}

/// Marked when it departs from its paper.
std::string marked(const Entry& e) {
  const bool adapted = !servo::find_controller(e.controller).adaptations.empty();
  std::string text = e.label() + (adapted ? " *" : "");
  if (e.own_speed) text += (std::isnan(e.speed_m_s) ? ", " : " at ") + speed_text(e);
  return text;
}

std::string row(const Contestant& c) {
  const Standing s = standing_of(c);
  return fmt::format("{:<30}{:>4} of {:<4}{:3.0f}-{:<3.0f}{}{}{}{}{}{}{}{}{}{}{}{}{}{}\n", marked(c.entry),
                     s.arrived, s.runs, 100 * s.success_ci95.low, 100 * s.success_ci95.high,
                     cell_cm(s.mean("rmse_m")), cell_cm(s.mean("mean_m")), cell_cm(s.mean("p95_m")),
                     cell_cm(s.max_m), cell_cm(s.mean("settled_rmse_m")), cell_cm(s.mean("turn_max_m")),
                     cell_cm(s.mean("terminal_error_m"), 10), cell_cm(s.mean("hold_mean_m")),
                     cell_cm(s.hold_max_m), cell(s.mean("duration_s"), 8, 1),
                     cell(s.mean("tilt_rate_rms_rad_s"), 7, 3), cell(100 * s.junction_accuracy, 8, 2),
                     cell(s.perception_ms, 7, 3), cell(s.control_ms, 9, 3));
}

std::string row(const PublishedRow& r) {
  const double nothing = std::nan("");
  return fmt::format("{:<45}{}{}{}{}{}{}{}{}{}{}{}{}  {}\n",
                     fmt::format("published: {} ({})", r.who, r.source), cell_cm(r.rmse_m), cell_cm(r.mean_m),
                     cell_cm(nothing), cell_cm(r.max_m), cell_cm(nothing), cell_cm(nothing),
                     cell_cm(r.terminal_error_m, 10), cell_cm(nothing), cell_cm(nothing),
                     cell(r.duration_s.value_or(nothing), 8, 1), cell(nothing, 7, 3),
                     cell(100 * r.junction_accuracy.value_or(nothing), 8, 2), r.note);
}

std::string heading(const ComparisonResult& result, const Entry& e) {
  const ComparisonOptions& o = result.options;
  const std::string speed = e.own_speed ? "each at the speed of its own paper" : speed_text(e);
  return fmt::format(
      "\n{}, {}, {}: {}, seeds {} to {}\n"
      "{:<30}{:>15}{:>8}{:>8}{:>8}{:>8}{:>8}{:>8}{:>10}{:>8}{:>8}{:>8}{:>7}{:>8}{:>7}{:>9}\n"
      "{:<30}{:>12}{:>3}{:>8}{:>8}{:>8}{:>8}{:>8}{:>8}{:>10}{:>8}{:>8}{:>8}{:>7}{:>8}{:>7}{:>9}\n",
      e.layout, o.conditions, speed, fmt::join(e.instructions, " "), o.seed,
      o.seed + static_cast<std::uint64_t>(o.runs - 1), "", "arrived 95 %", "RMSE", "mean", "p95", "max",
      "settled", "turn", "terminal", "hover", "hover", "time", "tilt", "code", "perc.", "control", "", "", "",
      "cm", "cm", "cm", "cm", "cm", "max cm", "cm", "cm", "max cm", "s", "rad/s", "%", "ms", "ms");
}

std::string difference_cell(const Pair& p) {
  const PairedDifference& d = p.difference;
  if (d.pairs == 0) return "-";
  if (d.pairs == 1) return fmt::format("{:+.2f} (one pair)", 100 * d.mean);
  return fmt::format("{:+.2f} [{:+.2f}, {:+.2f}]", 100 * d.mean, 100 * d.ci95.low, 100 * d.ci95.high);
}

/// The differences that the terminal shows; the JSON has them all.
bool is_shown(std::string_view metric) {
  return metric == "rmse_m" || metric == "max_m" || metric == "terminal_error_m";
}

std::string pairs_text(const std::vector<Pair>& pairs, const std::string& group) {
  std::string text;
  const Entry* last = nullptr;
  for (const Pair& p : pairs) {
    if (p.a->group != group || !is_shown(p.metric)) continue;
    if (p.a != last) text += fmt::format("{}  {:<45}", last ? "\n" : "", p.a->label() + " - " + p.b->label());
    last = p.a;
    text += fmt::format("{:<30}", difference_cell(p));
  }
  if (text.empty()) return text;
  return fmt::format("  {:<45}{:<30}{:<30}{:<30}\n", "mean difference [95 %], cm", "RMSE", "max",
                     "terminal") +
         text + "\n";
}

std::string published_text(const ComparisonResult& result, const std::string& title) {
  std::string text;
  if (result.preset.empty()) return text;
  for (const PublishedRow& r : published_beside(title)) text += row(r);
  return text;
}

std::string adaptations_text(const ComparisonResult& result) {
  std::set<std::string> named;
  std::string text;
  for (const Contestant& c : result.contestants) {
    const auto& adaptations = servo::find_controller(c.entry.controller).adaptations;
    if (adaptations.empty() || !named.insert(c.entry.controller).second) continue;
    text += fmt::format("  {}: {}\n", c.entry.controller, fmt::join(adaptations, "; "));
  }
  return text.empty() ? text : "\n* departs from its paper so as to fly here:\n" + text;
}

std::string failures_text(const ComparisonResult& result) {
  std::string text;
  std::map<std::string, std::size_t> outcomes;
  std::size_t failed = 0;
  for (const Contestant& c : result.contestants) {
    for (const ComparedFlight& flight : c.flights) {
      if (flight.summary.succeeded()) continue;
      ++outcomes[flight.summary.outcome];
      if (++failed > kCommandsShown) continue;
      text += fmt::format("  {:<10} {}\n", flight.summary.outcome, flight.command);
    }
  }
  if (failed > kCommandsShown)
    text += fmt::format("  and {} more, in comparison.json\n", failed - kCommandsShown);
  std::string counts;
  for (const auto& [outcome, count] : outcomes) counts += fmt::format(", {} {}", count, outcome);
  return text.empty() ? text : fmt::format("\nfailed flights: {}{}\n", failed, counts) + text;
}

std::string bars(const ErrorDistribution& bins) {
  const double all = static_cast<double>(std::accumulate(bins.begin(), bins.end(), 0L));
  std::string text;
  for (std::size_t i = 0; i < bins.size(); ++i) {
    if (bins[i] == 0) continue;
    const double share = static_cast<double>(bins[i]) / all;
    const double from_cm = 100 * kErrorBin_m * static_cast<double>(i);
    const std::string range = i + 1 == bins.size() ? fmt::format("{:.0f} and more", from_cm)
                                                   : fmt::format("{:.0f} to {:.0f} cm", from_cm, from_cm + 5);
    text += fmt::format("  {:>14} {:6.2f} % {}\n", range, 100 * share,
                        std::string(static_cast<std::size_t>(std::lround(50 * share)), '#'));
  }
  return text;
}

}  // namespace

std::string comparison_table(const ComparisonResult& result) {
  const std::vector<Pair> pairs = pairs_of(result.contestants, reference_of(result.options));
  std::string text;
  for (std::size_t i = 0; i < result.contestants.size();) {
    const Entry& first = result.contestants[i].entry;
    text += heading(result, first);
    for (; i < result.contestants.size() && result.contestants[i].entry.group == first.group; ++i)
      text += row(result.contestants[i]);
    text += published_text(result, first.title) + pairs_text(pairs, first.group);
  }
  return text + adaptations_text(result) + failures_text(result);
}

std::string error_histogram(const ComparisonResult& result) {
  std::string text = "\nHow the errors are distributed, share of the samples:\n";
  for (const Contestant& c : result.contestants) {
    text += fmt::format("{} on {}, {}\n{}", c.entry.label(), c.entry.layout, speed_text(c.entry),
                        bars(standing_of(c).distribution));
  }
  return text;
}

}  // namespace lineservo::apps
