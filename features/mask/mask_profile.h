#pragma once

#include <optional>
#include <vector>

#include "features/geometry/points.h"
#include "features/mask/packed_mask.h"

namespace lineservo::features {

/// How many foreground pixels every column and every row of a mask holds. Densities, centroid and area all
/// follow from these.
struct MaskProfile {
  std::vector<int> columns, rows;
  int foreground = 0;
};

MaskProfile profile_of(const PackedMask& mask);
/// The same into existing memory.
void profile_of(const PackedMask& mask, MaskProfile& profile);

/// Mean position of the foreground, topology eq. 2, in pixels of the mask; none when it is empty.
std::optional<PixelPoint> centroid(const MaskProfile& profile);

/// Share of the mask that is foreground, 0…1.
double foreground_ratio(const MaskProfile& profile);

}  // namespace lineservo::features
