#include "apps/cli/flight_printer.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

#include "features/geometry/angles.h"

namespace lineservo::apps {
namespace {

constexpr double kQuietInterval_s = 30.0;

/// "fork -45° 45° 180°"
std::string fork(const servo::NodeSignature& s) {
  std::string text(name(s.bend));
  for (const double arm_rad : s.arms_rad) text += fmt::format(" {:.0f}°", features::degrees(arm_rad));
  return text;
}

std::string codes(const servo::NodeSignature& s) {
  if (s.bend == servo::Bend::fork) return fork(s);
  if (s.bend != servo::Bend::none) return std::string(name(s.bend));
  const std::string code(features::name(s.code));
  if (s.line_ends)
    return code + (s.code == features::JunctionCode::straight ? " (the line ends)" : " (corner or end)");
  return std::string(features::name(s.preview)) + "→" + code;
}

std::string turning(double turn_rad) {
  const double angle_deg = std::abs(features::degrees(turn_rad));
  if (angle_deg > 179.5) return "turn round";
  return angle_deg < 0.5 ? "go straight"
                         : fmt::format("turn {:.0f}° {}", angle_deg, turn_rad > 0 ? "left" : "right");
}

/// What is done at a target before the next one.
std::string stopping(const servo::PlanStep& step, bool is_last) {
  std::string text = "hover";
  if (step.stop.hover_s) text += fmt::format(" {:g} s", *step.stop.hover_s);
  if (step.stop.look) text += ", look round";
  if (step.stop.land) text += ", land";
  if (step.stop.ground_s > 0.0) text += fmt::format(" for {:g} s", step.stop.ground_s);
  return is_last ? text : text + ", " + turning(step.turn_rad);
}

std::string action(const servo::PlanStep& step, bool is_last) {
  if (step.manoeuvre == servo::Manoeuvre::hover) return stopping(step, is_last);
  return step.manoeuvre == servo::Manoeuvre::turn ? turning(step.turn_rad)
                                                  : std::string(name(step.manoeuvre));
}

/// "a13: to n13, starting towards 0°"; of a mission all targets.
std::string headline(const servo::Plan& plan) {
  std::string targets;
  for (const std::size_t index : servo::target_steps(plan))
    targets += (targets.empty() ? "" : ", ") + plan.steps[index].node;
  return fmt::format("{}: to {}, starting towards {:.0f}°\n", plan.instruction, targets,
                     features::degrees(plan.start_heading_rad));
}

std::string centimetres(double metres) {
  return std::isfinite(metres) ? fmt::format("{:.1f} cm", 100.0 * metres) : "–";
}

void print_target(const TargetScore& t) {
  fmt::print("  target {} ({}): {}", t.target, t.node, t.outcome);
  if (t.rest)
    fmt::print(" after {:.0f} s, terminal error {}", t.rest->until_s, centimetres(t.rest->target_error_m));
  if (t.landing_W) fmt::print(", landed {} off", centimetres((*t.landing_W - t.node_W).norm()));
  fmt::print("\n");
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
  fmt::print("{}", headline(plan));
  for (const servo::PlanStep& step : plan.steps) {
    fmt::print("  {:<14} after {:5.2f} m  {:<18} {}\n", step.node, step.edge_length_m, codes(step.expected),
               action(step, &step == &plan.steps.back()));
  }
}

void print_summary(const FlightRequest& request, const FlightRecord& record, const FlightSummary& s) {
  fmt::print("{} with {} on {}, {} at {:.4g} m/s, seed {}: {}\n", request.instruction, request.controller,
             request.layout, request.conditions, request.settings.speed_m_s, request.seed, s.outcome);
  if (record.abort_reason != servo::AbortReason::none)
    fmt::print("  because: {}\n", servo::name(record.abort_reason));
  if (s.targets.size() > 1) {
    for (const TargetScore& target : s.targets) print_target(target);
  } else if (s.rest) {
    fmt::print("  terminal error {}\n", centimetres(s.rest->target_error_m));
  }
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
