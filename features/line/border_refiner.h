#pragma once

#include <optional>

#include "features/line/course_view.h"
#include "features/line/edge_gauge.h"

namespace lineservo::features {

/// How the borders of a course are refined on the image.
struct RefinerOptions {
  int passes = 3;
  int points_per_border = 600;  ///< at most, and none closer together than 1.5 px
  int reach_px = 5;             ///< of the last passes either way of the border; less on a narrow stripe
  double least_support = 0.2;   ///< share of the border in view that must be found again
};

/// A course with what its refinement rests on.
struct RefinedCourse {
  CurvedFit fit;
  CourseStretch stretch;
  double support = 0.0;  ///< share of the border in view that was found, 0…1
};

/// Refines a stripe's course on the image itself (ours): measures both borders along their normals to a
/// fraction of a pixel, takes lens and tilt out of the points, and fits course, width and, where they are
/// significant, curvature and taper.
class BorderRefiner {
 public:
  /// Throws std::invalid_argument for options out of bounds.
  explicit BorderRefiner(const RefinerOptions& options = {});

  /// `error_px`: how far off the course may be. `shape`: taper where the tilt is not known; curvature is
  /// always tried. None when the image does not show the borders.
  std::optional<RefinedCourse> refine(const cv::Mat& image, const CameraPose& pose, const CurvedCourse& start,
                                      const CourseStretch& stretch, double error_px,
                                      const FreeShape& shape) const;

 private:
  RefinerOptions options_;
};

}  // namespace lineservo::features
