#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>

#include "vehicle/time.h"

namespace lineservo::vehicle {

/// A delivered image.
struct Frame {
  Time stamp{0};           ///< mid-exposure
  std::int64_t index = 0;  ///< counts exposures from 0
  cv::Mat bgr;             ///< 8-bit BGR; the camera does not write to it while it is held
};

}  // namespace lineservo::vehicle
