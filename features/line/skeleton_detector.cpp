#include "features/line/skeleton_detector.h"

#include <algorithm>

#include "features/geometry/angles.h"
#include "features/line/hough_lines.h"
#include "features/line/mask_pixels.h"

namespace lineservo::features {
namespace {

// Between two of Hough's directions a line fills a bin of 1 px over 115 px at most, however long it is.
constexpr int kMostVotes = 100;

}  // namespace

std::vector<ImageLine> SkeletonDetector::find(const PackedMask& mask) {
  PackedMask skeleton = mask;
  thinner_.thin(skeleton);
  const int least_votes = std::clamp(std::min(mask.width(), mask.height()) / 5, 8, kMostVotes);
  const ClusterReach reach{.rho_px = std::max(mask.width(), mask.height()) / 20.0,
                           .theta_rad = radians(10.0)};
  return cluster_lines(hough_lines(unpacked(skeleton), least_votes), reach);
}

}  // namespace lineservo::features
