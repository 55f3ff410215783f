#include "features/line/skeleton_detector.h"

#include <algorithm>

#include "features/geometry/angles.h"
#include "features/line/hough_lines.h"
#include "features/line/mask_pixels.h"

namespace lineservo::features {

std::vector<ImageLine> SkeletonDetector::find(const PackedMask& mask) {
  PackedMask skeleton = mask;
  thinner_.thin(skeleton);
  const int least_votes = std::max(8, std::min(mask.width(), mask.height()) / 5);
  const ClusterReach reach{.rho_px = std::max(mask.width(), mask.height()) / 20.0,
                           .theta_rad = radians(10.0)};
  return cluster_lines(hough_lines(unpacked(skeleton), least_votes), reach);
}

}  // namespace lineservo::features
