#pragma once

#include <optional>

#include "features/geometry/points.h"
#include "features/mask/packed_mask.h"

namespace lineservo::features {

/// vtp §3.1 with the values of its published code, for a frame of 160×120.
struct ArcMask {
  double inner_px = 27.0;
  double outer_px = 28.0;
  double half_angle_rad = 62.0 * 3.14159265358979323846 / 180.0;  ///< Θ/2, either way of the last direction
};

/// The virtual target point: where the path crosses the arc around the image centre.
struct VirtualTarget {
  PixelPoint point_px;
  double direction_rad = 0.0;  ///< from the image's up, counter-clockwise, in (−π, π]
};

/// The mean of the path's pixels on the arc about the previous direction. Without one the arc is a full ring,
/// which a line crosses twice: there only the pixels within the half-angle of that one nearest to up count,
/// or the mean would be the centre. None when the path does not cross the arc. Throws std::invalid_argument
/// unless 0 < inner ≤ outer and the half-angle is in (0, π].
std::optional<VirtualTarget> virtual_target(const PackedMask& path, std::optional<double> previous_rad,
                                            const ArcMask& arc = {});

}  // namespace lineservo::features
