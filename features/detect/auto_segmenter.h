#pragma once

#include <optional>
#include <vector>

#include "features/detect/wedge_lines.h"
#include "features/mask/color_contrast.h"
#include "features/mask/segmenter.h"

namespace lineservo::features {

struct AutoSegmenterOptions {
  std::vector<LineColor> colors = {kLineColors.begin(), kLineColors.end()};  ///< those that may be found
  std::vector<ContrastReach> reaches = {{0.25}, {0.6}, {1.0}};
  std::vector<double> thresholds = {0.3, 0.45, 0.6};  ///< of the full contrast
  double least_hue_contrast = 0.14;                   ///< below this nothing is painted in that hue
  double least_lightness_contrast = 0.18;             ///< below this nothing is painted lighter or darker
  double least_hue_width = 0.008;    ///< of a line with a hue of its own, in widths of the image
  double least_white_width = 0.012;  ///< and of a white one
  double least_black_width = 0.016;  ///< and of a black one: joints between tiles are black and narrower
  double lightness_trust = 0.85;     ///< a line with a hue of its own goes before one without
  double largest_share = 0.55;       ///< of the image that a line and its arms cover: more is floor
  double min_evidence = 0.3;         ///< below this there is no line
};

/// What was found to be paint.
struct ColorChoice {
  LineColor color = LineColor::yellow;
  double evidence = 0.0;  ///< how sure it is, 0…1
  PackedMask mask;
  WedgeLines seen;
};

/// Finds the line's colour by itself, for cameras and floors that nobody has tuned: every colour is tried
/// against floors of several reaches at several thresholds, and the mask that looks most like painted stripes
/// is taken.
class AutoSegmenter : public Segmenter {
 public:
  explicit AutoSegmenter(const AutoSegmenterOptions& options = {});

  /// Empty when nothing looks like a line.
  PackedMask segment(const cv::Mat& image, cv::Size mask_size) override;

  /// The best mask of every colour in which a line is seen, the surest first. `geometry`: of the camera, at
  /// the size of the masks.
  std::vector<ColorChoice> choices(const cv::Mat& image, const MaskGeometry& geometry) const;

  /// Of the last segment(): the colour and how sure it is; none when there was no line.
  const std::optional<LineColor>& color() const { return color_; }
  double evidence() const { return evidence_; }

 private:
  std::optional<ColorChoice> best_of(LineColor color, const cv::Mat& bgr, WedgeLineFinder& finder) const;
  double least_contrast(LineColor color) const;
  double least_width(LineColor color) const;
  double trust(LineColor color, double full_contrast) const;
  void try_thresholds(LineColor color, const cv::Mat& contrast, WedgeLineFinder& finder,
                      std::optional<ColorChoice>& best) const;

  AutoSegmenterOptions options_;
  std::optional<LineColor> color_;
  double evidence_ = 0.0;
};

}  // namespace lineservo::features
