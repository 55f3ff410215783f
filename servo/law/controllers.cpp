#include "servo/law/controllers.h"

#include <stdexcept>

namespace lineservo::servo {

namespace {

constexpr std::string_view kHeadingHeld =
    "the executive holds the heading on the line, in the place of a compass";
constexpr std::string_view kTurnsOnLine = "the executive ends its turns on the line's angle";
constexpr std::string_view kOurJunctions = "junctions by our recogniser";
constexpr std::string_view kLedOverJunctions =
    "over junctions it takes the line from our recogniser; its paper has none";
constexpr std::string_view kSpeedHeld =
    "pitch in proportion to the wanted speed, held by the velocity estimate";
constexpr std::string_view kRollTurned = "roll towards the line; printed with the other sign";
constexpr std::string_view kYawTurnedOut = "the line's angle is turned out at a rate, not commanded";
constexpr std::string_view kAlg2Read = "roll and pitch of Alg. 2 as its text means them";
constexpr std::string_view kGainsOurs = "gains by pole placement; the paper prints none";
constexpr std::string_view kPlainLineOnly =
    "the point counts on a plain line only; past junctions it flies by odometry and the drift learnt";
constexpr std::string_view kTurnedInHover =
    "where lines branch the executive turns it in hover; its paper flies sideways";
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
      {"grid",
       "PID on roll, pitch and yaw rate from filtered lines, hovers on the node (grid)",
       {false, true},
       "stripe",
       {.line_method = "combined"},
       0.0,
       {kOurJunctions, kTurnsOnLine, kSpeedHeld, kGainsOurs},
       [](const LawOptions& o) -> std::unique_ptr<FollowLaw> { return std::make_unique<GridLaw>(o.grid); }},
      {"lfpf",
       "attitude from the fitted line's midpoint and slope (lfpf Alg. 3)",
       {false, true},
       "stripe",
       {.line_method = "fitline", .tilt_corrected = false},
       0.09,
       {kOurJunctions, kLedOverJunctions, kTurnsOnLine, kSpeedHeld, kRollTurned, kYawTurnedOut},
       [](const LawOptions& o) -> std::unique_ptr<FollowLaw> { return std::make_unique<LfpfLaw>(o.lfpf); }},
      {"carrot",
       "turns towards a point ahead on the line (lfpf Alg. 1)",
       {false, true},
       "stripe",
       {.line_method = "", .boundary_centres = true, .tilt_corrected = false},
       0.46,
       {kOurJunctions, kLedOverJunctions, kTurnsOnLine, kSpeedHeld},
       [](const LawOptions& o) -> std::unique_ptr<FollowLaw> {
         return std::make_unique<CarrotLaw>(o.carrot);
       }},
      {"improved-carrot",
       "the same with roll and less pitch in a turn (lfpf Alg. 2)",
       {false, true},
       "stripe",
       {.line_method = "", .boundary_centres = true, .tilt_corrected = false},
       0.46,
       {kOurJunctions, kLedOverJunctions, kTurnsOnLine, kSpeedHeld, kAlg2Read},
       [](const LawOptions& o) -> std::unique_ptr<FollowLaw> {
         return std::make_unique<ImprovedCarrotLaw>(o.improved_carrot);
       }},
      {"vtp",
       "pure pursuit of the virtual target point by position steps (vtp)",
       {.servos_on_node = false, .steers_heading = false, .pursues_line = true},
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
