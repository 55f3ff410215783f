#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>
#include <string>

#include "features/frame_features.h"
#include "features/geometry/camera_model.h"
#include "features/geometry/level_view.h"
#include "features/line/line_detector.h"
#include "features/mask/mask_geometry.h"
#include "features/mask/path_segmenter.h"

namespace lineservo::features {

/// What a law looks at besides the stripes, the junction and the codes. Each costs time: only what is asked
/// for is computed.
struct FeatureNeeds {
  std::string line_method;  ///< of line_methods(): fills LawFeatures::lines; empty: no such lines
  bool boundary_centres = false;
  bool target_point = false;
  /// In the level camera; otherwise in the camera as it hangs, for papers that do not correct for tilt.
  bool tilt_corrected = true;
};

/// Fills LawFeatures from a frame and its masks: lines and boundary centres from the paint, which runs on
/// under the start marker. Keeps buffers and the last direction of the target point.
class LawFeatureExtractor {
 public:
  /// Throws std::invalid_argument for a line method that there is not.
  LawFeatureExtractor(const CameraModel& camera, const MaskGeometry& geometry, const FeatureNeeds& needs);

  LawFeatures extract(const cv::Mat& bgr, const Segmentation& segmentation,
                      const std::optional<PixelPoint>& centroid_px, const LevelView& view);

 private:
  std::vector<LineFeature> find_lines(const cv::Mat& bgr, const PackedMask& path, const LevelView& view);
  LevelPoint level(PixelPoint mask_px, const LevelView& view) const;

  MaskGeometry geometry_;
  FeatureNeeds needs_;
  CameraPose pose_;
  std::unique_ptr<LineDetector> line_detector_;
};

}  // namespace lineservo::features
