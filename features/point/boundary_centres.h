#pragma once

#include <optional>

#include "features/geometry/points.h"
#include "features/mask/packed_mask.h"

namespace lineservo::features {

/// In pixels of the paper's own frame, 640×480.
struct BoundaryOptions {
  int band_x_px = 20;     ///< along the left and the right edge
  int band_y_px = 20;     ///< along the upper and the lower edge
  int least_pixels = 20;  ///< of a part: less is noise
};

/// The same share of another mask, which may be scaled unevenly; whole pixels, at least 1.
BoundaryOptions carried_over(const BoundaryOptions& options, int width_px, int height_px);

/// Where the path enters and leaves the image, lfpf §3.3.2: W_i+1 is the upper one, W_i the lower one.
struct BoundaryCentres {
  std::optional<PixelPoint> ahead;   ///< W_i+1
  std::optional<PixelPoint> behind;  ///< W_i
};

/// Centroids of the path's parts in the band along the image's edges. Of more than two, as at a crossing, the
/// topmost and the lowest; a single one is ahead when it lies in the upper half. The options are in pixels of
/// this mask. Throws std::invalid_argument for a band below 1 px or above half the image.
BoundaryCentres boundary_centres(const PackedMask& path, const BoundaryOptions& options = {});

}  // namespace lineservo::features
