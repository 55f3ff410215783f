#pragma once

#include <optional>

#include "features/geometry/camera_model.h"
#include "features/geometry/points.h"
#include "features/mask/packed_mask.h"

namespace lineservo::features {

/// Centroid of the start marker's mask when it holds more than `limit_px` pixels (topology §2.5: 350).
std::optional<PixelPoint> start_disc(const PackedMask& marker, int limit_px = 350);

/// The centre of the end disc, vtp §3.1: the mask is eroded by a disc of `radius_px` (in the published code
/// 11 px), which no stripe narrower than that disc survives; the centroid of what is left, or none. What lies
/// outside the mask erodes nothing. Throws std::invalid_argument unless the radius is 1 to 500 px.
std::optional<PixelPoint> end_disc(const PackedMask& path, double radius_px = 11.0);

/// The same in a mask of any size: the mask is brought to vtp's frame, 160 px wide and as high as the
/// camera's shape makes it, and the radius to the camera and height: on the floor it stays what it is in the
/// published flight, 8.3 cm, between the disc's 10 cm and the line's 5 cm. Pixels of the given mask.
std::optional<PixelPoint> end_disc_as_published(const PackedMask& path, const CameraModel& camera,
                                                double height_m);

}  // namespace lineservo::features
