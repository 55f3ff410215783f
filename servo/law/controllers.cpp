#include "servo/law/controllers.h"

#include <stdexcept>

namespace lineservo::servo {

namespace {

constexpr std::string_view kHeadingHeld =
    "the executive holds the heading on the line, in the place of a compass";
constexpr std::string_view kTurnsOnLine = "the executive ends its turns on the line's angle";
constexpr std::string_view kPlainLineOnly =
    "the point counts on a plain line only; past junctions it flies by odometry and the drift learnt";
constexpr std::string_view kTurnedInHover = "the executive turns it in hover where its paper flies sideways";
constexpr std::string_view kArcFollowsStripe =
    "arc of 1.6 half stripe widths and erosion in proportion, unless it flies its own red track";
constexpr std::string_view kArcNeverSmaller =
    "arc of 1.6 half stripe widths, but never smaller than the published one, and erosion in proportion";
constexpr std::string_view kStepsInMetres =
    "steps in metres, scaled so that a target straight ahead is approached at the speed asked for";

}  // namespace

const std::vector<Controller>& controllers() {
  static const std::vector<Controller> kControllers = {
      {"ibvs",
       "visual servoing on the fitted line, docking on nodes (ours)",
       {true, true},
       "stripe",
       {},
       0.0,
       {},
       [](const LawOptions& o) -> std::unique_ptr<FollowLaw> {
         return std::make_unique<IbvsLineLaw>(o.ibvs);
       }},
      {"ibvs-centroid",
       "visual servoing on the centroid of the path's mask, docking on nodes (ours)",
       {true, false},
       "stripe",
       {},
       0.0,
       {kHeadingHeld, kPlainLineOnly},
       [](const LawOptions& o) -> std::unique_ptr<FollowLaw> {
         return std::make_unique<IbvsPointLaw>(PathPoint::centroid, o.ibvs_centroid);
       }},
      {"ibvs-point",
       "visual servoing on the virtual target point, docking on nodes (ours)",
       {true, false},
       "stripe",
       {.target_point = true, .least_arc_px = VtpOptions{}.arc_px},
       0.0,
       {kHeadingHeld, kPlainLineOnly, kArcNeverSmaller},
       [](const LawOptions& o) -> std::unique_ptr<FollowLaw> {
         return std::make_unique<IbvsPointLaw>(PathPoint::target, o.ibvs_point);
       }},
      {"pid",
       "lateral PID on the mask's centroid, fixed turns (topology)",
       {false, false, true},
       "fpd",
       {},
       0.1,
       {kHeadingHeld, kTurnsOnLine},
       [](const LawOptions& o) -> std::unique_ptr<FollowLaw> { return std::make_unique<PidLaw>(o.pid); }},
      {"vtp",
       "pure pursuit of the virtual target point by position steps (vtp)",
       {false, false},
       "fpd",
       {.target_point = true, .tilt_corrected = false},
       published_speed_m_s(VtpOptions{}),
       {kHeadingHeld, kTurnedInHover, kArcFollowsStripe, kStepsInMetres},
       [](const LawOptions& o) -> std::unique_ptr<FollowLaw> { return std::make_unique<VtpLaw>(o.vtp); }},
  };
  return kControllers;
}

const Controller& find_controller(std::string_view name) {
  std::string names;
  for (const Controller& controller : controllers()) {
    if (controller.name == name) return controller;
    names += (names.empty() ? "" : ", ") + std::string(controller.name);
  }
  throw std::invalid_argument("unknown controller '" + std::string(name) + "'; there are: " + names);
}

}  // namespace lineservo::servo
