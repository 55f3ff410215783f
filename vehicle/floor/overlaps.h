#pragma once

#include <string>
#include <vector>

#include "vehicle/floor/layout.h"

namespace lineservo::vehicle {

/// Where lines cross or run over each other although nothing joins them there: one message for each pair of
/// edges, with the place. Near a node the paint of its lines may touch, for as long as lines that part at 25°
/// do. The indices and centrelines of the layout must be sound.
std::vector<std::string> overlaps(const Layout& layout);

}  // namespace lineservo::vehicle
