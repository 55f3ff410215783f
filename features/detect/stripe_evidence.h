#pragma once

#include <opencv2/core/mat.hpp>

#include "features/detect/wedge_lines.h"

namespace lineservo::features {

/// What is known of the paint that a mask shows.
struct PaintContrast {
  cv::Mat contrast;            ///< CV_8UC1, the size of the mask
  double full = 0.0;           ///< of the paint, in levels
  double least_width = 0.0;    ///< of a line, in widths of the image: joints between tiles are narrower
  double largest_share = 0.7;  ///< of the image that may be paint
};

/// How sharp the borders of a line are: the step of the contrast across the softer one, 1 when it is that of
/// paint. A border out of view does not count; 0 when both are. Shadows and glare have soft borders.
double sharpness(const WedgeLine& line, const PaintContrast& paint, const MaskGeometry& geometry);

/// How much a line looks painted: straight and sharp borders, both in view, long, and long for its width
/// unless the view cuts it at both ends. 0…1.
double line_evidence(const WedgeLine& line, const PaintContrast& paint, const MaskGeometry& geometry);

/// Share of the foreground that lies on the lines, 0…1.
double explained_share(const PackedMask& mask, const std::vector<WedgeLine>& lines,
                       const MaskGeometry& geometry);

/// Weighs every line, drops those that are not credible, and says how much the mask looks like painted lines
/// and nothing else: evidence of its best line and some of the others', times what the lines explain of it;
/// 0 where paint covers less than 0.2 % or more than 70 %.
double judge(const PackedMask& mask, const PaintContrast& paint, const MaskGeometry& geometry,
             WedgeLines& seen);

}  // namespace lineservo::features
