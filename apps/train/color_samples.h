#pragma once

#include <cstdint>
#include <vector>

#include "features/mask/color_svm.h"
#include "features/mask/line_color.h"

namespace lineservo::apps {

/// Colours to train on, drawn from the seed: paint of the colour, and floors and other paints, as a camera
/// shows them in bright and dim, warm and cold light, through glare, with noise. Half of each.
std::vector<features::ColorSample> color_samples(features::LineColor paint, int count, std::uint64_t seed);

}  // namespace lineservo::apps
