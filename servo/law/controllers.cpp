#include "servo/law/controllers.h"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "features/line/line_methods.h"

namespace lineservo::servo {

namespace {

constexpr const char* kHeadingHeld = "the executive holds the heading on the line, in the place of a compass";
constexpr const char* kTurnsOnLine = "the executive ends its turns on the line's angle";
constexpr const char* kOurJunctions = "junctions by our recogniser";
constexpr const char* kLedOverJunctions =
    "over junctions it takes the line from our recogniser; its paper has none";
constexpr const char* kSpeedHeld = "pitch in proportion to the wanted speed, held by the velocity estimate";
constexpr const char* kRollTurned = "roll towards the line; printed with the other sign";
constexpr const char* kYawTurnedOut = "the line's angle is turned out at a rate, not commanded";
constexpr const char* kAlg2Read = "roll and pitch of Alg. 2 as its text means them";
constexpr const char* kGainsOurs = "gains by pole placement; the paper prints none";
constexpr const char* kPlainLineOnly =
    "the point counts on a plain line only; past junctions it flies by odometry and the drift learnt";
constexpr const char* kTurnedInHover =
    "where lines branch the executive turns it in hover; its paper flies sideways";
constexpr const char* kArcFollowsStripe =
    "arc of 1.6 half stripe widths and erosion in proportion, unless it flies its own red track";
constexpr const char* kArcNeverSmaller =
    "arc of 1.6 half stripe widths, but never smaller than the published one, and erosion in proportion";
constexpr const char* kStepsInMetres =
    "steps in metres, scaled so that a target straight ahead is approached at the speed asked for";

std::deque<Controller> shipped() {
  return {
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
}

// A deque: adding to it leaves every Controller& as it is.
std::deque<Controller>& registry() {
  static std::deque<Controller> all = shipped();
  return all;
}

constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyz", kDigits = "0123456789";

bool is_plain(std::string_view name, std::string_view others) {
  const std::string allowed = std::string(kLetters) + std::string(kDigits) + std::string(others);
  return name.find_first_of(kLetters) == 0 && name.find_first_not_of(allowed) == name.npos;
}

[[noreturn]] void refuse(const Controller& controller, const std::string& why) {
  throw std::invalid_argument("controller '" + controller.name + "': " + why);
}

bool is_taken(const std::string& name) {
  const auto has_it = [&name](const Controller& controller) { return controller.name == name; };
  return name == "dock" || std::any_of(registry().begin(), registry().end(), has_it);  // servo.dock.* is set
}

void check_gains(const Controller& controller) {
  std::set<std::string> names;
  for (const OwnGain& gain : controller.gains) {
    if (!is_plain(gain.name, "-_")) refuse(controller, "'" + gain.name + "' is not a plain name of a gain");
    if (!names.insert(gain.name).second) refuse(controller, "it has two gains '" + gain.name + "'");
    const bool in_range = gain.low <= gain.value && gain.value <= gain.high;
    if (!in_range) refuse(controller, "the gain '" + gain.name + "' is not between its low and its high");
  }
}

void check(const Controller& controller) {
  if (!is_plain(controller.name, "-"))
    refuse(controller, "its name must be of lower-case letters, digits and '-', a letter first");
  if (is_taken(controller.name)) refuse(controller, "its name is taken");
  if (!controller.make) refuse(controller, "it makes no law");
  if (controller.junction_method != "stripe" && controller.junction_method != "fpd")
    refuse(controller, "its junction method must be stripe or fpd");
  if (!controller.needs.line_method.empty()) features::find_line_method(controller.needs.line_method);
  check_gains(controller);
}

}  // namespace

std::map<std::string, double, std::less<>> own_gains() {
  std::map<std::string, double, std::less<>> gains;
  for (const Controller& controller : controllers())
    for (const OwnGain& gain : controller.gains) gains[controller.name + "." + gain.name] = gain.value;
  return gains;
}

double LawOptions::own_gain(std::string_view key) const {
  const auto it = own.find(key);
  if (it == own.end()) throw std::out_of_range("no controller has the gain '" + std::string(key) + "'");
  return it->second;
}

const std::deque<Controller>& controllers() {
  return registry();
}

void add_controller(Controller controller) {
  check(controller);
  registry().push_back(std::move(controller));
}

const Controller& find_controller(std::string_view name) {
  std::string names;
  for (const Controller& controller : controllers()) {
    if (controller.name == name) return controller;
    names += (names.empty() ? "" : ", ") + controller.name;
  }
  throw std::invalid_argument("unknown controller '" + std::string(name) + "'; there are: " + names);
}

}  // namespace lineservo::servo
