#include "features/law_features.h"

#include "features/line/line_methods.h"
#include "features/point/boundary_centres.h"

namespace lineservo::features {

LawFeatureExtractor::LawFeatureExtractor(const CameraModel& camera, const MaskGeometry& geometry,
                                         const FeatureNeeds& needs, const PathLook& look)
    : geometry_(geometry),
      needs_(needs),
      pose_{camera, LevelView()},
      line_detector_(needs.line_method.empty() ? nullptr : find_line_method(needs.line_method).make()) {
  if (!needs.target_point) return;
  TargetOptions target = look.target;
  target.least_arc_px = needs.least_arc_px;
  target_finder_.emplace(camera, look.ranges, look.segmenter, target);
}

LawFeatures LawFeatureExtractor::extract(const cv::Mat& bgr, const Segmentation& segmentation,
                                         const SeenByAll& seen, const FrameContext& context) {
  const LevelView used = needs_.tilt_corrected ? context.view : LevelView();
  LawFeatures features;
  if (seen.centroid_px) features.centroid = level(*seen.centroid_px, used);
  if (line_detector_) features.lines = find_lines(bgr, segmentation.paint, used);
  if (needs_.boundary_centres) {
    const PackedMask& path = segmentation.paint;
    const BoundaryCentres centres =
        boundary_centres(path, carried_over(BoundaryOptions{}, path.width(), path.height()));
    if (centres.ahead) features.ahead = level(*centres.ahead, used);
    if (centres.behind) features.behind = level(*centres.behind, used);
  }
  if (target_finder_) features.target = find_target(bgr, seen, context, used);
  return features;
}

std::optional<LevelPoint> LawFeatureExtractor::find_target(const cv::Mat& bgr, const SeenByAll& seen,
                                                           const FrameContext& context,
                                                           const LevelView& view) {
  if (!context.on_the_way) target_finder_->forget_direction();
  const std::optional<NormalizedPoint> target = target_finder_->find(bgr, seen.stripe_width);
  if (!target) return std::nullopt;
  return view.level(*target);
}

std::vector<LineFeature> LawFeatureExtractor::find_lines(const cv::Mat& bgr, const PackedMask& path,
                                                         const LevelView& view) {
  pose_.view = view;
  std::vector<LineFeature> lines;
  for (const DetectedLine& line : line_detector_->detect({bgr, path, &pose_})) lines.push_back(*line.level);
  return lines;
}

LevelPoint LawFeatureExtractor::level(PixelPoint mask_px, const LevelView& view) const {
  return view.level(geometry_.normalize(mask_px));
}

}  // namespace lineservo::features
