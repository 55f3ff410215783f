#pragma once

#include <filesystem>

#include "vehicle/floor/layout.h"

namespace lineservo::apps {

/// Reads a layout (data/README.md). Keys: name, description, floor {colour}, bitmap {file, metres_per_pixel,
/// x_m, y_m}, line {width_m, colour}, nodes
/// [{name, x_m, y_m}], edges [{from, to, arc: {centre: [x, y], direction: left | right}, through: [[x, y]…],
/// width_m, colour}], start {node, marker_radius_m, marker_colour}, end_markers [{node, radius_m, colour}],
/// labels {DIF: node}. Colours are [red, green, blue], 0…255. Throws InputError naming file, line and key.
vehicle::Layout read_layout(const std::filesystem::path& file);

}  // namespace lineservo::apps
