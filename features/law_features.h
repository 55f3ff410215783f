#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>
#include <string>

#include "features/frame_context.h"
#include "features/frame_features.h"
#include "features/geometry/camera_model.h"
#include "features/line/line_detector.h"
#include "features/mask/mask_geometry.h"
#include "features/mask/path_segmenter.h"
#include "features/point/target_finder.h"

namespace lineservo::features {

/// What a law looks at besides the stripes, the junction and the codes. Each costs time: only what is asked
/// for is computed.
struct FeatureNeeds {
  std::string line_method = {};  ///< of line_methods(): fills LawFeatures::lines; empty: no such lines
  bool boundary_centres = false;
  bool target_point = false;
  /// Radius that the target point's arc keeps on narrow stripes, in pixels of vtp's frame.
  double least_arc_px = 0.0;
  /// In the level camera; otherwise in the camera as it hangs, for papers that do not correct for tilt.
  bool tilt_corrected = true;
};

/// How the path is told from the floor, for features that have a frame of their own, and what the target
/// point takes of it.
struct PathLook {
  SegmenterOptions ranges = {};
  SegmenterChoice segmenter = {};
  TargetOptions target = {};
};

/// What was seen of the frame for all laws.
struct SeenByAll {
  std::optional<PixelPoint> centroid_px;  ///< of the path mask
  std::optional<double> stripe_width;     ///< of the stripe to follow, normalised units
};

/// Fills LawFeatures from a frame and its masks: lines and boundary centres from the paint, which runs on
/// under the start marker. Keeps buffers and what the target point remembers.
class LawFeatureExtractor {
 public:
  /// Throws std::invalid_argument for a line method that there is not.
  LawFeatureExtractor(const CameraModel& camera, const MaskGeometry& geometry, const FeatureNeeds& needs,
                      const PathLook& look = {});

  LawFeatures extract(const cv::Mat& bgr, const Segmentation& segmentation, const SeenByAll& seen,
                      const FrameContext& context);

 private:
  std::vector<LineFeature> find_lines(const cv::Mat& bgr, const PackedMask& path, const LevelView& view);
  std::optional<LevelPoint> find_target(const cv::Mat& bgr, const SeenByAll& seen,
                                        const FrameContext& context, const LevelView& view);
  LevelPoint level(PixelPoint mask_px, const LevelView& view) const;

  MaskGeometry geometry_;
  FeatureNeeds needs_;
  CameraPose pose_;
  std::unique_ptr<LineDetector> line_detector_;
  std::optional<TargetFinder> target_finder_;
};

}  // namespace lineservo::features
