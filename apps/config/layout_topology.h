#pragma once

#include "servo/plan/topology.h"
#include "vehicle/floor/layout.h"

namespace lineservo::apps {

/// What the executive may know of a floor: the layout without its coordinates.
servo::Topology topology_of(const vehicle::Layout& layout);

}  // namespace lineservo::apps
