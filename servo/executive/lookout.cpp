#include "servo/executive/lookout.h"

#include <algorithm>
#include <cmath>

#include "features/geometry/angles.h"

namespace lineservo::servo {
namespace {

using features::wrap_angle;

constexpr double kSameArm_rad = features::radians(15.0);
constexpr double kBelow_heights = 0.4;  // further off it is another node

std::string in_degrees(double angle_rad) {
  return std::to_string(std::lround(features::degrees(angle_rad))) + "°";
}

}  // namespace

void Lookout::observe(const Observation& observation) {
  ++frames_;
  discs_ += observation.features.start_marker ? 1 : 0;
  const auto& junction = observation.features.junction;
  if (!junction || junction->centre.vector().norm() > kBelow_heights) return;
  ++junctions_;
  const double turned_rad = observation.estimate.odometry_at_capture.yaw_rad - heading_rad_;
  for (const features::ArmFeature& arm : junction->arms) add(wrap_angle(arm.angle_rad + turned_rad));
}

void Lookout::add(double angle_rad) {
  for (Arm& arm : arms_) {
    const double off_rad = wrap_angle(angle_rad - arm.angle_rad);
    if (std::abs(off_rad) > kSameArm_rad) continue;
    ++arm.frames;
    arm.angle_rad = wrap_angle(arm.angle_rad + off_rad / arm.frames);
    return;
  }
  arms_.push_back({angle_rad, 1});
}

std::vector<double> Lookout::arms_rad() const {
  std::vector<double> angles;
  for (const Arm& arm : arms_) {
    const bool is_back = arm.angle_rad < kSameArm_rad - features::kPi;  // by a noise's breadth on the right
    if (2 * arm.frames >= junctions_) angles.push_back(arm.angle_rad + (is_back ? 2.0 * features::kPi : 0.0));
  }
  std::sort(angles.begin(), angles.end());
  return angles;
}

std::string Lookout::told() const {
  std::string list;
  for (const double angle_rad : arms_rad()) list += (list.empty() ? "" : ", ") + in_degrees(angle_rad);
  const std::string disc = 2 * discs_ > frames_ ? "; red disc" : "";
  return (list.empty() ? "no junction" : "junction with arms at " + list) + disc;
}

}  // namespace lineservo::servo
