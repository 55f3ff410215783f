#pragma once

#include <optional>
#include <vector>

#include "features/line/image_line.h"

namespace lineservo::features {

/// How many pairs are tried, and what supports a line.
struct RansacOptions {
  int rounds = 200;
  double reach_px = 5.0;  ///< of a point from the line that it supports
  int least_points = 3;
};

/// The line that most of the points support, fitted to those by least squares. The pairs that are tried are
/// the same in every call; all of them when there are not more pairs than rounds. None if too few support it.
std::optional<ImageLine> ransac_line(const std::vector<PixelPoint>& points, const RansacOptions& options);

}  // namespace lineservo::features
