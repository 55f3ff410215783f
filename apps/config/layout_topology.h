#pragma once

#include <vector>

#include "servo/plan/topology.h"
#include "vehicle/floor/layout.h"

namespace lineservo::apps {

/// What the executive may know of a floor: the layout without its coordinates.
servo::Topology topology_of(const vehicle::Layout& layout);

/// The markers that the published colours take for red: what reads J0 when it comes into view.
std::vector<vehicle::LayoutMarker> red_discs(const vehicle::Layout& layout);

}  // namespace lineservo::apps
