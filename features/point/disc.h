#pragma once

#include <opencv2/core/types.hpp>
#include <optional>

#include "features/geometry/points.h"
#include "features/mask/packed_mask.h"

namespace lineservo::features {

/// Centroid of the start marker's mask when it holds more than `limit_px` pixels (topology §2.5: 350).
std::optional<PixelPoint> start_disc(const PackedMask& marker, int limit_px = 350);

/// The centre of the end disc, vtp §3.1: the mask is eroded by a disc of `radius_px` (in the published code
/// 11 px), which no stripe narrower than that disc survives; the centroid of what is left, or none. What lies
/// outside the mask erodes nothing. Throws std::invalid_argument unless the radius is 1 to 500 px.
std::optional<PixelPoint> end_disc(const PackedMask& path, int radius_px = 11);

/// The same in a mask of any size: the mask is brought to the frame that the published radius is for, 160 px
/// wide and as high as the camera's shape makes it. Pixels of the given mask.
std::optional<PixelPoint> end_disc_as_published(const PackedMask& path, cv::Size camera_size);

}  // namespace lineservo::features
