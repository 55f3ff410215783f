#pragma once

#include <opencv2/core/mat.hpp>

#include "vehicle/random.h"

namespace lineservo::apps {

/// What real pictures suffer from, each a function on an 8-bit BGR image that draws all it needs from
/// `random`.

/// Multiplies by a smooth field of gains in [low, high].
void uneven_light(cv::Mat& bgr, double low, double high, vehicle::Random& random);

/// Adds a soft white spot of up to `strength` levels somewhere.
void specular_patch(cv::Mat& bgr, double strength, vehicle::Random& random);

/// Gaussian blur; none for σ under 0.1 px.
void soften(cv::Mat& bgr, double sigma_px);

/// Draws turned rectangles and cables, in colours that no line has, of up to a tenth of the image's width.
void clutter(cv::Mat& bgr, int objects, vehicle::Random& random);

/// The blocks of JPEG: colour at half resolution, 8×8 cosine transform, coefficients rounded to the standard
/// tables at a quality of 1…100 (ISO/IEC 10918-1, annex K).
void jpeg_blocks(cv::Mat& bgr, int quality);

}  // namespace lineservo::apps
