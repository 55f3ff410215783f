#pragma once

#include <optional>

#include "features/detect/auto_segmenter.h"

namespace lineservo::features {

/// When the colour of the paint is kept from frame to frame, and when given up.
struct SteadyOptions {
  AutoSegmenterOptions search = {};
  double strong_hue = 0.35;    ///< saturation beyond the floor's that is paint whatever its shape, 1 = 255
  double strong_share = 0.05;  ///< of the image that has it
  double sure = 0.5;           ///< evidence of a frame that counts for a colour
  int agreeing_frames = 3;     ///< in a row that must show the same colour before it is kept
  int forgiven_frames = 5;     ///< in a row without paint before the colour is given up
  double threshold = 0.45;     ///< between floor and paint
  double renewal = 0.1;        ///< weight of a frame in the levels of floor and paint
  double least_share = 0.002;  ///< of the image that is painted when a line is in view
};

/// The automatic segmenter for the frames of one camera: once the line's colour is plain, it and the levels
/// of floor and paint are kept. A single frame can mislead: over a crossing of broad lines most of it is
/// paint, and what is left of the floor looks like lines.
class SteadySegmenter : public Segmenter {
 public:
  /// Throws std::invalid_argument for counts below 1 and for shares that are none.
  explicit SteadySegmenter(const SteadyOptions& options = {});

  PackedMask segment(const cv::Mat& image, cv::Size mask_size) override;

  /// The colour that is kept; none as long as it is not plain.
  std::optional<LineColor> color() const;

 private:
  /// A colour with what floor and paint measure in its cue.
  struct Paint {
    LineColor color = LineColor::yellow;
    double floor = 0.0, paint = 0.0;  ///< levels
  };

  PackedMask search(const cv::Mat& bgr);
  std::optional<PackedMask> strong_hue(const cv::Mat& bgr) const;
  bool is_sure(const AutoSegmenter& seen) const { return seen.color() && seen.evidence() >= options_.sure; }
  void consider(const AutoSegmenter& seen, const cv::Mat& bgr, const PackedMask& mask);
  PackedMask kept_paint(const cv::Mat& bgr);
  void renew(const cv::Mat& cue, const PackedMask& mask, double weight);

  SteadyOptions options_;
  std::optional<AutoSegmenter> hues_, lightnesses_;  ///< the searches; none for no such colour
  std::optional<Paint> kept_;
  std::optional<LineColor> candidate_;
  int agreeing_ = 0, without_paint_ = 0;
};

}  // namespace lineservo::features
