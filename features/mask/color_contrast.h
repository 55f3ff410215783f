#pragma once

#include <opencv2/core/mat.hpp>

#include "features/mask/line_color.h"

namespace lineservo::features {

/// Against what a pixel is compared: the floor around it, out to a share of the image's shorter side, or the
/// floor of the whole image (for stripes so wide that no neighbourhood reaches past them).
struct ContrastReach {
  double share = 0.4;  ///< of the shorter side, above 0 and below 1; 1: the whole image
  double floor_share =
      0.4;  ///< with the whole image: the quantile that is floor; paint covers the rest at most
};

/// How much each pixel looks like paint of a colour beside the floor around it, CV_8UC1, 255 = 1.
///
/// Lightness is compared as a ratio, 1 − darker / lighter, which uneven light leaves as it is; hue as the
/// difference of saturations (min(R, G) − B) / max for yellow and (R − max(G, B)) / max for red. The floor
/// around a pixel is the opening (closing for black) by a square of the reach: no stripe narrower than that
/// survives it, crossings neither.
cv::Mat color_contrast(const cv::Mat& bgr, LineColor color, ContrastReach reach);

/// What color_contrast() compares: saturation of the colour's hue, or lightness for white and black. CV_8UC1.
cv::Mat color_cue(const cv::Mat& bgr, LineColor color);

}  // namespace lineservo::features
