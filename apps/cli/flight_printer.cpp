#include "apps/cli/flight_printer.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

#include "features/geometry/angles.h"

namespace lineservo::apps {
namespace {

constexpr double kQuietInterval_s = 30.0;

std::string codes(const servo::NodeSignature& s) {
  if (s.bend != servo::Bend::none) return std::string(name(s.bend));
  const std::string code(features::name(s.code));
  if (s.line_ends)
    return code + (s.code == features::JunctionCode::straight ? " (the line ends)" : " (corner or end)");
  return std::string(features::name(s.preview)) + "→" + code;
}

std::string action(const servo::PlanStep& step) {
  if (step.manoeuvre != servo::Manoeuvre::turn) return std::string(name(step.manoeuvre));
  return fmt::format("turn {:.0f}° {}", std::abs(features::degrees(step.turn_rad)),
                     step.turn_rad > 0 ? "left" : "right");
}

std::string centimetres(double metres) {
  return std::isfinite(metres) ? fmt::format("{:.1f} cm", 100.0 * metres) : "–";
}

}  // namespace

ProgressLine::ProgressLine(std::string instruction)
    : instruction_(std::move(instruction)), on_terminal_(::isatty(STDERR_FILENO) == 1) {}

void ProgressLine::show(const FlightProgress& p) {
  if (!on_terminal_ && p.time_s < next_s_) return;
  next_s_ = p.time_s + kQuietInterval_s;
  const std::string line =
      fmt::format("{}{}: {:5.0f} s  {:<8}  node {} of {}{}", on_terminal_ ? "\r" : "", instruction_, p.time_s,
                  servo::name(p.phase), std::min(p.step + 1, p.steps), p.steps, on_terminal_ ? "   " : "\n");
  std::fputs(line.c_str(), stderr);  // a closed stderr must not end the flight
  std::fflush(stderr);
}

void ProgressLine::clear() {
  if (on_terminal_) fmt::print(stderr, "\r{:60}\r", "");
}

void print_plan(const servo::Plan& plan) {
  fmt::print("{}: to {}, starting towards {:.0f}°\n", plan.instruction, plan.target,
             features::degrees(plan.start_heading_rad));
  for (const servo::PlanStep& step : plan.steps) {
    fmt::print("  {:<14} after {:5.2f} m  {:<18} {}\n", step.node, step.edge_length_m, codes(step.expected),
               action(step));
  }
}

void print_summary(const FlightRequest& request, const FlightRecord& record, const FlightSummary& s) {
  fmt::print("{} with {} on {}, {} at {} m/s, seed {}: {}\n", request.instruction, request.controller,
             request.layout, request.conditions, request.settings.speed_m_s, request.seed, s.outcome);
  if (record.abort_reason != servo::AbortReason::none)
    fmt::print("  because: {}\n", servo::name(record.abort_reason));
  if (s.rest) fmt::print("  terminal error {}\n", centimetres(s.rest->target_error_m));
  for (const LegScore& leg : s.track.legs) {
    fmt::print("  leg {} to {}: RMSE {}, max {}, settled {}, at the turn {}\n", leg.from, leg.to,
               centimetres(leg.whole.rmse_m), centimetres(leg.whole.max_m), centimetres(leg.settled_rmse_m),
               centimetres(leg.turn_max_m));
  }
  const JunctionScore& j = s.junctions;
  if (j.frames > 0) {
    fmt::print("  junction codes: {:.2f} % of {} frames right, {} of {} nodes\n",
               100.0 * j.accuracy(j.misclassified), j.frames, j.events_right, j.events);
  }
  fmt::print("  {:.1f} s flown in {:.2f} s ({:.0f} times real time)\n", s.duration_s, s.timing.wall_s,
             s.duration_s / s.timing.wall_s);
}

}  // namespace lineservo::apps
