#pragma once

#include <array>
#include <vector>

#include "apps/config/camera/camera_entries.h"
#include "features/geometry/camera_model.h"

namespace lineservo::apps {

/// Takes the focal lengths and the principal point from a 3×3 matrix, row by row,
///   fx 0 cx | 0 fy cy | 0 0 1.
/// Throws InputError when it is not of that form (a skew is refused: no CameraModel has one).
void take_matrix(const CameraEntries& entries, const Spellings& keys, features::CameraParameters& camera);

/// k1, k2, p1, p2, k3 from OpenCV's list of coefficients, k1 k2 p1 p2 [k3 [k4 k5 k6 [s1 … s4 [τx τy]]]]; a
/// list that is empty is no distortion. Throws InputError for other lengths, and when a term behind k3 is not
/// 0.
void take_lens(const CameraEntries& entries, const Spellings& keys, features::CameraParameters& camera);

/// Says that no CameraModel holds the lens model that the entry names.
[[noreturn]] void refuse_lens(const CameraEntries& entries, const CameraEntry& entry);

}  // namespace lineservo::apps
