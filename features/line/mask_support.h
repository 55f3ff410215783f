#pragma once

#include <optional>

#include "features/line/image_line.h"
#include "features/mask/packed_mask.h"

namespace lineservo::features {

/// Not nearly empty, not nearly full, at least 16 px a side.
bool may_hold_line(const PackedMask& mask);

/// A line of a mask with what the mask says of it: end points, width, quality (the painted share between the
/// ends) and covariance (from how the middles of the paint scatter about it). None where less than half of
/// it is painted, where it is shorter than a tenth of the mask, or where the paint has no sides.
std::optional<ImageLine> supported_line(const ImageLine& line, const PackedMask& mask);

}  // namespace lineservo::features
