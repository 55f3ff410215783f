#include "apps/overlay/junction_sign.h"

#include <cmath>
#include <vector>

#include "apps/overlay/ink.h"
#include "features/geometry/angles.h"

namespace lineservo::apps {
namespace {

using features::JunctionCode;
using features::radians;

constexpr double kForward = 0.0, kLeft = radians(90.0), kBack = radians(180.0), kRight = radians(-90.0);

std::vector<double> arms_of(JunctionCode code) {
  switch (code) {
    case JunctionCode::straight:
      return {kForward, kBack};
    case JunctionCode::cross:
      return {kForward, kBack, kLeft, kRight};
    case JunctionCode::corner_right:
      return {kBack, kRight};
    case JunctionCode::corner_left:
      return {kBack, kLeft};
    case JunctionCode::tee_behind:
      return {kForward, kLeft, kRight};
    case JunctionCode::tee_ahead:
      return {kBack, kLeft, kRight};
    case JunctionCode::tee_right:
      return {kForward, kBack, kRight};
    case JunctionCode::tee_left:
      return {kForward, kBack, kLeft};
    case JunctionCode::start:
    case JunctionCode::unrecognised:
      break;
  }
  return {};
}

std::vector<double> arms_of(const servo::NodeSignature& node) {
  switch (node.bend) {
    case servo::Bend::left:
      return {kBack, radians(45.0)};
    case servo::Bend::right:
      return {kBack, radians(-45.0)};
    case servo::Bend::fork:
      return node.arms_rad;
    case servo::Bend::none:
      break;
  }
  return arms_of(node.code);
}

void draw_arms(Canvas& canvas, cv::Point2d centre, double radius_px, const std::vector<double>& arms_rad) {
  const double r = radius_px * canvas.scale();
  for (const double arm_rad : arms_rad)
    canvas.line(centre, centre - r * cv::Point2d(std::sin(arm_rad), std::cos(arm_rad)), {ink::kText, 5.0});
}

}  // namespace

void draw_sign(Canvas& canvas, cv::Point2d centre, double radius_px, JunctionCode code) {
  if (code == JunctionCode::start) return canvas.disc(centre, 0.6 * radius_px, ink::kVermilion);
  if (code == JunctionCode::unrecognised) {
    const double s = canvas.scale();
    return canvas.text(centre + s * cv::Point2d(-6.0, 8.0), "?", 16.0, {ink::kLabel, 2.0});
  }
  draw_arms(canvas, centre, radius_px, arms_of(code));
}

void draw_sign(Canvas& canvas, cv::Point2d centre, double radius_px, const servo::NodeSignature& node) {
  if (node.bend == servo::Bend::none) return draw_sign(canvas, centre, radius_px, node.code);
  draw_arms(canvas, centre, radius_px, arms_of(node));
}

std::string short_name(const servo::NodeSignature& node) {
  return std::string(node.bend == servo::Bend::none ? features::name(node.code) : servo::name(node.bend));
}

}  // namespace lineservo::apps
