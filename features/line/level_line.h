#pragma once

#include "features/line/line_detector.h"

namespace lineservo::features {

/// ∂(ρ, θ in the level camera)/∂(ρ in pixels, θ), the ends kept where they are along the line.
Eigen::Matrix2d level_jacobian(const ImageLine& line, const CameraPose& pose);

/// The covariance in the image of a line whose covariance in the level camera is known.
Eigen::Matrix2d image_covariance(const ImageLine& line, const Eigen::Matrix2d& level, const CameraPose& pose);

/// A line of an image as seen by the virtual level camera. Lens distortion is taken out of its end points.
LineFeature level_line(const ImageLine& line, const CameraPose& pose);

}  // namespace lineservo::features
