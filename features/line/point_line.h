#pragma once

#include <span>

#include "features/line/image_line.h"

namespace lineservo::features {

/// Total least squares: the line through the mean of the points along their major axis. At least two points.
ImageLine fit_line(std::span<const PixelPoint> points);

}  // namespace lineservo::features
