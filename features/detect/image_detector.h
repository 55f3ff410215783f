#pragma once

#include <optional>
#include <vector>

#include "features/detect/detect_methods.h"
#include "features/geometry/camera_model.h"
#include "features/junction/junction_code.h"

namespace lineservo::features {

/// A line in pixels of the image as given: x cosθ + y sinθ = ρ, origin at the centre of the top-left pixel.
struct PixelLine {
  double rho_px = 0.0;
  double theta_rad = 0.0;  ///< in (−π/2, π/2]
  PixelPoint begin, end;   ///< of its centreline in view; end is forward
  double width_px = 0.0;   ///< at its middle
  double quality = 0.0;    ///< 0…1
};

/// The line through two points that differ.
PixelLine pixel_line(PixelPoint begin, PixelPoint end);

/// What is seen in one picture. What was not seen is absent.
struct ImageDetection {
  std::vector<PixelLine> lines;  ///< every line in view, the best to follow first
  std::optional<PixelPoint> centroid_px;
  JunctionCode code = JunctionCode::unrecognised;
  std::optional<PixelPoint> junction_px;
  double foreground_ratio = 0.0;
  std::optional<LineColor> color;  ///< of the paint; none without a line
  double evidence = 0.0;           ///< how sure the colour is, 0…1
};

struct ImageDetectorOptions {
  AutoSegmenterOptions segmenter;
  const DetectMethod* method = &detect_methods().front();
  std::optional<CameraParameters> camera;  ///< without one: assumed_geometry()
  int longest_side_px = 640;               ///< larger pictures are looked at in this size
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

  ImageDetectorOptions options_;
  AutoSegmenter segmenter_;
};

}  // namespace lineservo::features
