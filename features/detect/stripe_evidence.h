#pragma once

#include <opencv2/core/mat.hpp>

#include "features/detect/image_lines.h"

namespace lineservo::features {

/// How much a line looks painted: straight borders over its length, long for its width, and a sharp step of
/// the contrast (CV_8UC1, the size of the mask) across both borders. 0…1.
double line_evidence(const ImageLine& line, const cv::Mat& contrast, double full_contrast,
                     const MaskGeometry& geometry);

/// Share of the foreground that lies on the lines, 0…1.
double explained_share(const PackedMask& mask, const std::vector<ImageLine>& lines,
                       const MaskGeometry& geometry);

/// How much a mask looks like painted lines and nothing else: evidence of its best line and some of the
/// others', times what the lines explain of it; 0 where paint covers less than 0.2 % or more than 65 %.
double mask_evidence(const PackedMask& mask, const ImageLines& seen, const cv::Mat& contrast,
                     double full_contrast, const MaskGeometry& geometry);

}  // namespace lineservo::features
