#pragma once

#include "features/line/curved_fit.h"
#include "features/line/line_detector.h"

namespace lineservo::features {

/// Where a point of the level camera lies in the image, lens distortion included.
PixelPoint project(const CameraPose& pose, const Eigen::Vector2d& p_L);

/// The stretch of a course that is painted and in view, by arc length from its foot.
struct CourseStretch {
  double from = 0.0, to = 0.0;
};

/// A fitted course as a line of the level camera: its tangent at the arc length `along`. `floor`: the least
/// standard deviation of offset and direction.
LineFeature level_tangent(const CurvedFit& fit, const CourseStretch& stretch, double along, double quality,
                          double floor);

/// A fitted course as a line of the image and of the level camera, tangent at the place of the stretch that
/// is nearest to the image centre.
DetectedLine view_course(const CurvedFit& fit, const CourseStretch& stretch, const CameraPose& pose,
                         double quality);

}  // namespace lineservo::features
