#pragma once

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
};

/// What one controller is, for the command line and for the executive.
struct Controller {
  std::string_view name;
  std::string_view summary;
  LawTraits traits;
  std::string_view junction_method;  ///< the recogniser that it flies with unless told otherwise
  features::FeatureNeeds needs;
  double published_speed_m_s = 0.0;  ///< of its paper's flights; 0: none
  /// Where it departs from its paper so as to fly here, for the tables.
  std::vector<std::string_view> adaptations;
  std::unique_ptr<FollowLaw> (*make)(const LawOptions&);
};

/// All controllers that ship.
const std::vector<Controller>& controllers();

/// Throws std::invalid_argument, with the names that there are, for an unknown one.
const Controller& find_controller(std::string_view name);

}  // namespace lineservo::servo
