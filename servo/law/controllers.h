#pragma once

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "features/law_features.h"
#include "servo/law/carrot_law.h"
#include "servo/law/grid_law.h"
#include "servo/law/ibvs_line_law.h"
#include "servo/law/ibvs_point_law.h"
#include "servo/law/improved_carrot_law.h"
#include "servo/law/lfpf_law.h"
#include "servo/law/pid_law.h"
#include "servo/law/vtp_law.h"

namespace lineservo::servo {

/// One parameter of a controller of one's own: the setting `servo.CONTROLLER.NAME`.
struct OwnGain {
  std::string name;    ///< letters, digits, '-' and '_'; with its unit: "offset_gain_per_s"
  double value = 0.0;  ///< unless it is set
  double low = 0.0, high = 100.0;
};

/// "CONTROLLER.NAME" and value of every gain of the controllers that were added.
std::map<std::string, double, std::less<>> own_gains();

/// Parameters of every law.
struct LawOptions {
  IbvsLineOptions ibvs;
  IbvsPointOptions ibvs_centroid;
  IbvsPointOptions ibvs_point;
  PidOptions pid;
  GridOptions grid;
  LfpfOptions lfpf;
  CarrotOptions carrot;
  ImprovedCarrotOptions improved_carrot;
  VtpOptions vtp;
  std::map<std::string, double, std::less<>> own = own_gains();

  /// A parameter of a controller that was added, by "CONTROLLER.NAME". Throws std::out_of_range.
  double own_gain(std::string_view key) const;
};

/// What one controller is, for the command line and for the executive.
struct Controller {
  std::string name;
  std::string summary;  ///< a line, for lists
  LawTraits traits = {};
  std::string junction_method =
      "stripe";                       ///< the recogniser that it flies with unless told otherwise, or "fpd"
  features::FeatureNeeds needs = {};  ///< what it looks at besides the stripes and the junction
  double published_speed_m_s = 0.0;   ///< of its paper's flights; 0: none
  /// Where it departs from its paper so as to fly here, for the tables.
  std::vector<std::string> adaptations = {};
  /// A law for one flight; never null. Flights may run in parallel, each with a law of its own.
  std::function<std::unique_ptr<FollowLaw>(const LawOptions&)> make = {};
  std::vector<OwnGain> gains =
      {};  ///< of a controller that was added; those that ship have LawOptions' members
};

/// All controllers: those that ship, then those that were added.
const std::deque<Controller>& controllers();

/// Adds a controller of one's own to those that every command knows: fly, compare, watch, replay, tune and
/// the rest take it by its name. To be called before run_program(), or before any thread reads controllers().
/// Throws std::invalid_argument when the name is taken or is not a plain one (lower-case letters, digits and
/// '-', a letter first), when `make` is empty, when a method is unknown, or when a gain is out of its own
/// range.
void add_controller(Controller controller);

/// Throws std::invalid_argument, with the names that there are, for an unknown one.
const Controller& find_controller(std::string_view name);

}  // namespace lineservo::servo
