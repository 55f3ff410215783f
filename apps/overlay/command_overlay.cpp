#include "apps/overlay/command_overlay.h"

#include <algorithm>
#include <cmath>

#include "apps/overlay/ink.h"
#include "features/geometry/angles.h"

namespace lineservo::apps {
namespace {

constexpr double kFull_px = 90.0;
constexpr double kLongest = 1.7;  // of the full arrow; what is more is cut
constexpr double kLeast_px = 4.0;
constexpr double kFullTilt_rad = features::radians(5.0);
constexpr double kFullClimb_m_s = 0.5;
constexpr double kArc_px = 62.0;
constexpr double kLeastArc_rad = features::radians(2.0);
constexpr double kWidestArc_rad = features::radians(150.0);

const Stroke kForward{ink::kBlack, 4.0, 1.5, ink::kWhite};
const Stroke kYaw{ink::kBlack, 3.0, 1.5, ink::kWhite};

/// What a command asks for, as shares of the full arrows.
struct Shown {
  double forward = 0.0, left = 0.0, up = 0.0;
  double turn_rad = 0.0;  ///< in a second
};

double pixels(double share) {
  return kFull_px * std::clamp(share, -kLongest, kLongest);
}

// Nose down and right side down lead forward and to the right.
Shown shown(const servo::Command& command, double full_m_s) {
  if (const auto* v = std::get_if<servo::VelocityCommand>(&command))
    return {v->forward_m_s / full_m_s, v->left_m_s / full_m_s, v->up_m_s / kFullClimb_m_s, v->yaw_rate_rad_s};
  if (const auto* a = std::get_if<servo::AttitudeCommand>(&command))
    return {a->pitch_rad / kFullTilt_rad, -a->roll_rad / kFullTilt_rad, 0.0, a->yaw_rate_rad_s};
  return {};
}

void draw_arrow(Canvas& canvas, cv::Point2d from, cv::Point2d way_px) {
  if (std::hypot(way_px.x, way_px.y) < kLeast_px) return;
  canvas.arrow(from, from + canvas.scale() * way_px, kForward, 14.0);
}

void draw_yaw(Canvas& canvas, cv::Point2d centre, double turn_rad) {
  if (std::abs(turn_rad) < kLeastArc_rad) return;
  const double sweep_rad = std::clamp(turn_rad, -kWidestArc_rad, kWidestArc_rad);
  const double radius = kArc_px * canvas.scale();
  const auto at = [&](double angle_rad) {
    return centre - radius * cv::Point2d(std::sin(angle_rad), std::cos(angle_rad));
  };
  constexpr int kSteps = 24;
  std::vector<cv::Point2d> arc;
  for (int k = 0; k <= kSteps; ++k) arc.push_back(at(sweep_rad * k / kSteps));
  canvas.polyline(arc, kYaw);
  canvas.arrow(arc[kSteps - 1], at(sweep_rad + std::copysign(0.12, sweep_rad)), kYaw, 12.0);
}

void draw_climb(Canvas& canvas, const cv::Rect& area, double share) {
  const double length_px = pixels(share);
  if (std::abs(length_px) < kLeast_px) return;
  const cv::Point2d from(area.x + 26.0 * canvas.scale(), area.y + 0.5 * area.height);
  draw_arrow(canvas, from, {0.0, -length_px});
  const double below = length_px > 0.0 ? 18.0 : -8.0;
  canvas.text(from + canvas.scale() * cv::Point2d(-12.0, below), length_px > 0.0 ? "up" : "down", 10.0,
              {ink::kWhite, 1.0, 1.5, ink::kBlack});
}

}  // namespace

void draw_command(Canvas& canvas, const cv::Rect& area, const servo::Command& command, double full_m_s) {
  const cv::Point2d centre(area.x + 0.5 * (area.width - 1), area.y + 0.5 * (area.height - 1));
  if (std::holds_alternative<servo::LandCommand>(command)) {
    canvas.circle(centre, 24.0, kYaw);
    return draw_climb(canvas, area, -1.0);
  }
  const Shown s = shown(command, full_m_s);
  draw_yaw(canvas, centre, s.turn_rad);
  draw_arrow(canvas, centre, {0.0, -pixels(s.forward)});
  draw_arrow(canvas, centre, {-pixels(s.left), 0.0});
  draw_climb(canvas, area, s.up);
}

}  // namespace lineservo::apps
