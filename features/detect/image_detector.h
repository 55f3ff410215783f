#pragma once

#include <optional>
#include <string>
#include <vector>

#include "features/detect/auto_segmenter.h"
#include "features/geometry/camera_model.h"
#include "features/junction/junction_code.h"
#include "features/line/image_line.h"

namespace lineservo::features {

/// What is seen in one picture. What was not seen is absent.
struct ImageDetection {
  std::vector<ImageLine> lines;  ///< every line in view, the best to follow first
  std::optional<PixelPoint> centroid_px;
  JunctionCode code = JunctionCode::unrecognised;
  std::optional<PixelPoint> junction_px;
  double foreground_ratio = 0.0;
  std::optional<LineColor> color;  ///< of the paint; none without a line
  double evidence = 0.0;           ///< how sure the colour is, 0…1
};

/// How single pictures are looked at.
struct ImageDetectorOptions {
  AutoSegmenterOptions segmenter;
  std::string method =
      "stripe";  ///< of line_methods(); with stripe, borders may converge as those of a slanted view do
  std::optional<CameraParameters> camera;  ///< without one: assumed_geometry()
  int longest_side_px = 640;               ///< larger pictures are looked at in this size
  int finest_side_px = 1280;  ///< and once more in this one, for thin lines with a hue, when nothing was seen
};

/// Lines and junction in single pictures of any camera and size.
class ImageDetector {
 public:
  /// Throws std::invalid_argument for options out of bounds.
  explicit ImageDetector(const ImageDetectorOptions& options = {});

  /// Throws std::invalid_argument unless the image is CV_8UC3 or CV_8UC1, at least 16×16 px, and of the
  /// camera's size if there is a camera.
  ImageDetection detect(const cv::Mat& image) const;

 private:
  MaskGeometry geometry_for(cv::Size image_size) const;
  std::vector<ColorChoice> thin_paints(const cv::Mat& image, const MaskGeometry& geometry) const;
  ImageDetection told(const std::vector<ColorChoice>& paints, const cv::Mat& image,
                      const MaskGeometry& geometry) const;
  std::vector<ImageLine> lines_of(const ColorChoice& paint, const cv::Mat& image,
                                  const MaskGeometry& geometry) const;

  ImageDetectorOptions options_;
  AutoSegmenter segmenter_;
};

}  // namespace lineservo::features
