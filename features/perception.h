#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>
#include <string>

#include "features/detect/segmenters.h"
#include "features/frame_context.h"
#include "features/frame_features.h"
#include "features/geometry/camera_model.h"
#include "features/geometry/level_view.h"
#include "features/junction/code_filter.h"
#include "features/law_features.h"
#include "features/line/line_detector.h"
#include "features/mask/mask_profile.h"
#include "features/mask/path_segmenter.h"
#include "features/stripe_perception.h"
#include "features/track/line_tracker.h"

namespace lineservo::features {

/// Which recogniser gives the junction codes.
enum class JunctionMethod {
  fpd,     ///< foreground pixel densities, as published (topology §2.2)
  stripe,  ///< from the stripes that were found and the arms of their crossing (ours)
};

/// What becomes of the lines from frame to frame.
enum class LineFilter {
  none,
  kalman,  ///< the line to follow is tracked (LineTracker): filtered, predicted through short losses, kept
           ///< among parallels
};

/// What counts as the start or end disc.
enum class MarkerMethod {
  red,     ///< enough pixels of the red range, as published (topology §2.5)
  eroded,  ///< what is left of the path under a circular erosion (vtp §3.1), for paths that are red
           ///< themselves
};

/// Which methods look at a frame; the defaults are those that `ibvs` flies with.
struct PerceptionOptions {
  SegmenterOptions segmenter;
  /// Of segmenter_names(): with hsv the fast path with the ranges above; the others give the path's mask,
  /// while the start marker stays with the ranges.
  SegmenterChoice path;
  MarkerMethod marker = MarkerMethod::red;
  JunctionMethod junction_method = JunctionMethod::stripe;
  int junction_window = CodeFilter::kDefaultWindow;
  StripePerceptionOptions stripe;
  LineFilter line_filter = LineFilter::none;
  LineTrackerOptions tracker;
  /// Of line_methods(): where the line to follow comes from. The junctions always rest on the stripes, and
  /// where one is in view they stand in for a method that cannot tell their lines apart (with_stripes()).
  std::string line_method = "stripe";
  FeatureNeeds needs;  ///< of the law that flies
  TargetOptions target;
};

/// Frame → features: segmentation, centroid, stripes, junction and code. Remembers the code filter's window,
/// the tracked line and what the law's own features remember from frame to frame, nothing else.
class Perception {
 public:
  /// Throws std::invalid_argument for options out of bounds.
  Perception(const CameraModel& camera, const PerceptionOptions& options);

  /// `bgr`: CV_8UC3 of the camera's size, else std::invalid_argument.
  FrameFeatures observe(const cv::Mat& bgr, const FrameContext& context);

  /// The mask of the last frame, for overlays.
  const PackedMask& mask() const { return segmentation_->path; }

 private:
  std::optional<PixelPoint> find_marker(double height_m) const;
  void replace_path(const cv::Mat& bgr);
  std::optional<StripePrior> prior(const FrameContext& context) const;
  void track(std::vector<LineFeature>& lines, const FrameContext& context);
  std::vector<LineFeature> detect_lines(const cv::Mat& bgr, const LevelView& view);
  JunctionCode read_code(const StripeFeatures& stripes, bool& line_ends_ahead) const;

  PerceptionOptions options_;
  cv::Size frame_size_;
  PathSegmenter segmenter_;
  MaskGeometry geometry_;
  StripePerception stripes_;
  std::unique_ptr<LineDetector> line_detector_;  ///< none: the lines are the stripes
  CameraPose pose_;
  LawFeatureExtractor law_features_;
  CodeFilter filter_;
  LineTracker tracker_;
  MaskProfile profile_;
  std::unique_ptr<Segmenter> path_segmenter_;  ///< none: the fast path
  Segmentation replaced_;
  const Segmentation* segmentation_ = nullptr;
  std::optional<PixelPoint> marker_px_;  ///< of the last frame, resized
};

}  // namespace lineservo::features
