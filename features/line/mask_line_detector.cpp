#include "features/line/mask_line_detector.h"

#include "features/line/level_line.h"
#include "features/line/mask_support.h"
#include "features/line/scene_check.h"

namespace lineservo::features {

std::vector<DetectedLine> MaskLineDetector::detect(const LineScene& scene) {
  require_image(scene.image);
  if (!is_large_enough(scene.image) || !may_hold_line(scene.mask)) return {};
  const cv::Size mask_size(scene.mask.width(), scene.mask.height());
  std::vector<DetectedLine> lines;
  for (const ImageLine& found : find(scene.mask)) {
    const auto line = supported_line(found, scene.mask);
    if (!line) continue;
    lines.push_back({rescaled(*line, mask_size, scene.image.size()), std::nullopt});
    if (scene.camera) lines.back().level = level_line(lines.back().image, *scene.camera);
  }
  return lines;
}

}  // namespace lineservo::features
