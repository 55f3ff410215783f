#pragma once

#include <opencv2/core/mat.hpp>
#include <optional>
#include <vector>

#include "features/frame_features.h"
#include "features/geometry/camera_model.h"
#include "features/geometry/level_view.h"
#include "features/line/image_line.h"
#include "features/line/stripe.h"
#include "features/mask/packed_mask.h"

namespace lineservo::features {

/// How the camera stood: intrinsics with lens distortion, and its tilt.
struct CameraPose {
  CameraModel camera;
  LevelView view;
};

/// What a detector may look at. Borrowed for the call.
struct LineScene {
  const cv::Mat& image;                ///< CV_8UC1 or CV_8UC3
  const PackedMask& mask;              ///< of the paint; may be smaller than the image, and scaled unevenly
  const CameraPose* camera = nullptr;  ///< null: nothing is known of the camera
  std::optional<StripePrior> prior = std::nullopt;  ///< of the followed stripe, in the level camera
};

/// A line in the image, and on the floor where that is known.
struct DetectedLine {
  ImageLine image;
  std::optional<LineFeature> level;  ///< in the virtual level camera, where the camera is known
};

/// Finds painted lines in an image. Detectors keep buffers, but remember nothing of earlier frames: the same
/// scene gives the same lines.
class LineDetector {
 public:
  virtual ~LineDetector() = default;

  /// The size that the mask should have for an image; others work too.
  virtual cv::Size mask_size(cv::Size image) const { return image; }
  /// Every line in view, best to follow first. Throws std::invalid_argument for an image of another type.
  virtual std::vector<DetectedLine> detect(const LineScene& scene) = 0;
};

}  // namespace lineservo::features
