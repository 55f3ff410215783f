#pragma once

#include <optional>
#include <vector>

#include "features/detect/stripe_evidence.h"
#include "features/detect/wedge_lines.h"
#include "features/mask/color_contrast.h"
#include "features/mask/segmenter.h"

namespace lineservo::features {

/// Which paints are looked for, and what must stand out for one to be found.
struct AutoSegmenterOptions {
  std::vector<LineColor> colors = {kLineColors.begin(), kLineColors.end()};  ///< those that may be found
  std::vector<ContrastReach> reaches = {{0.25}, {0.6}, {1.0}, {1.0, 0.25}};
  std::vector<double> thresholds = {0.3, 0.45, 0.6};  ///< of the full contrast
  double least_hue_contrast = 0.14;                   ///< below this nothing is painted in that hue
  double least_lightness_contrast = 0.18;             ///< below this nothing is painted lighter or darker
  double least_hue_width = 0.008;        ///< of a line with a hue of its own, in widths of the image
  double least_lightness_width = 0.012;  ///< of a white or black one: joints between tiles are narrower
  double plain_hue = 0.35;               ///< full contrast of paint that nobody can miss, 1 = 255
  double plain_white = 0.5;              ///< of white; planks of wood reach 0.4
  double plain_black = 0.65;             ///< of black; shadows reach 0.5
  double plain_grey = 0.28;  ///< of both in a grey picture, where paint of any hue is but lighter or darker
  double lightness_trust = 0.85;  ///< a line with a hue of its own goes before one without
  double largest_share = 0.7;     ///< of the image that a line and its arms cover: more is floor
  double min_evidence = 0.35;     ///< below this there is no line
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
  /// What counts for paint of one colour in one picture.
  struct Bar {
    LineColor color = LineColor::yellow;
    double least_contrast = 0.0, plain_contrast = 1.0, least_width = 0.0;
  };
  Bar bar_of(LineColor color, bool picture_has_hues) const;
  std::optional<ColorChoice> best_of(const Bar& bar, const cv::Mat& bgr, WedgeLineFinder& finder) const;
  double trust(const Bar& bar, double full_contrast) const;
  void try_thresholds(const Bar& bar, const PaintContrast& paint, double trusted, WedgeLineFinder& finder,
                      std::optional<ColorChoice>& best) const;

  AutoSegmenterOptions options_;
  std::optional<LineColor> color_;
  double evidence_ = 0.0;
};

}  // namespace lineservo::features
