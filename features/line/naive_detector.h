#pragma once

#include "features/line/line_detector.h"

namespace lineservo::features {

/// `naive`: Canny edges of the grey image and Hough transform, the comparison of grid Tab. II. It finds the
/// borders of a stripe, so it is off by half its width. Canny's thresholds are 50 and 150; a line needs the
/// votes of 0.35 of the image's short side, 150 at most. The best line up the image, then the best across it.
class NaiveDetector final : public LineDetector {
 public:
  std::vector<DetectedLine> detect(const LineScene& scene) override;
};

}  // namespace lineservo::features
