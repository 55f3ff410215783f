#include "servo/law/controllers.h"

#include <stdexcept>

namespace lineservo::servo {

namespace {

constexpr std::string_view kHeadingHeld =
    "the executive holds the heading on the line, in the place of a compass";
constexpr std::string_view kTurnsOnLine = "the executive ends its turns on the line's angle";

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
      {"pid",
       "lateral PID on the mask's centroid, fixed turns (topology)",
       {false, false},
       "fpd",
       {},
       0.1,
       {kHeadingHeld, kTurnsOnLine},
       [](const LawOptions& o) -> std::unique_ptr<FollowLaw> { return std::make_unique<PidLaw>(o.pid); }},
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
