#include "features/detect/steady_segmenter.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <utility>

#include "features/mask/mask_filter.h"

namespace lineservo::features {
namespace {

PackedMask cleaned(const cv::Mat& is_paint) {
  PackedMask mask = PackedMask::from_mat(is_paint);
  MaskFilter filter(mask.width(), mask.height());
  filter.median_5x5(mask, mask);
  filter.close_5x5(mask, mask);
  return mask;
}

template <typename Predicate>
std::optional<AutoSegmenter> search_among(AutoSegmenterOptions options, Predicate wanted) {
  std::erase_if(options.colors, [&](LineColor color) { return !wanted(color); });
  return options.colors.empty() ? std::nullopt : std::optional(AutoSegmenter(options));
}

}  // namespace

SteadySegmenter::SteadySegmenter(const SteadyOptions& options) : options_(options) {
  if (options.agreeing_frames < 1 || options.forgiven_frames < 1)
    throw std::invalid_argument("steady segmenter: the counts of frames must be at least 1");
  const auto is_share = [](double value) { return value > 0.0 && value < 1.0; };
  if (!is_share(options.threshold) || !is_share(options.renewal) || !is_share(options.least_share))
    throw std::invalid_argument(
        "steady segmenter: threshold, renewal and least share must lie between 0 and 1");
  hues_ = search_among(options.search, has_hue);
  lightnesses_ = search_among(options.search, [](LineColor color) { return !has_hue(color); });
}

std::optional<LineColor> SteadySegmenter::color() const {
  return kept_ ? std::optional(kept_->color) : std::nullopt;
}

PackedMask SteadySegmenter::segment(const cv::Mat& image, cv::Size mask_size) {
  require_segmentable(image, mask_size);
  const cv::Mat bgr = resized_bgr(image, mask_size);
  return kept_ ? kept_paint(bgr) : search(bgr);
}

// A disc on the line, or a node that fills the view, leaves no line that is plain. Strong colour is paint all
// the same, and floor between it looks like dark lines.
PackedMask SteadySegmenter::search(const cv::Mat& bgr) {
  PackedMask mask(bgr.cols, bgr.rows);
  if (hues_) mask = hues_->segment(bgr, bgr.size());
  if (hues_ && is_sure(*hues_)) {
    consider(*hues_, bgr, mask);
    return mask;
  }
  std::optional<PackedMask> strong = strong_hue(bgr);
  if (!strong && lightnesses_) {
    PackedMask seen = lightnesses_->segment(bgr, bgr.size());
    if (lightnesses_->color()) {
      consider(*lightnesses_, bgr, seen);
      return seen;
    }
  }
  agreeing_ = 0;
  return strong ? std::move(*strong) : std::move(mask);
}

std::optional<PackedMask> SteadySegmenter::strong_hue(const cv::Mat& bgr) const {
  for (const LineColor color : options_.search.colors) {
    if (!has_hue(color)) continue;
    const cv::Mat cue = color_cue(bgr, color);
    double floor = 0.0, paint = 0.0;
    cv::minMaxLoc(cue, &floor, &paint);
    if (paint - floor < 255.0 * options_.strong_hue) continue;
    PackedMask mask = cleaned(cue > floor + options_.threshold * (paint - floor));
    if (mask.count() > options_.strong_share * mask.width() * mask.height()) return mask;
  }
  return std::nullopt;
}

void SteadySegmenter::consider(const AutoSegmenter& seen, const cv::Mat& bgr, const PackedMask& mask) {
  agreeing_ = is_sure(seen) && seen.color() == candidate_ ? agreeing_ + 1 : int{is_sure(seen)};
  candidate_ = seen.color();
  if (agreeing_ < options_.agreeing_frames) return;
  kept_ = Paint{.color = *seen.color()};
  renew(color_cue(bgr, kept_->color), mask, 1.0);
  without_paint_ = 0;
}

PackedMask SteadySegmenter::kept_paint(const cv::Mat& bgr) {
  const cv::Mat cue = color_cue(bgr, kept_->color);
  const double limit = kept_->floor + options_.threshold * (kept_->paint - kept_->floor);
  const cv::Mat is_paint = kept_->paint > kept_->floor ? cv::Mat(cue > limit) : cv::Mat(cue < limit);
  PackedMask mask = cleaned(is_paint);
  if (mask.count() > options_.least_share * mask.width() * mask.height()) {
    without_paint_ = 0;
    renew(cue, mask, options_.renewal);
  } else if (++without_paint_ >= options_.forgiven_frames) {
    kept_.reset();
    candidate_.reset();
    agreeing_ = 0;
  }
  return mask;
}

// Levels move on with the light, each as long as enough of it is in view.
void SteadySegmenter::renew(const cv::Mat& cue, const PackedMask& mask, double weight) {
  const cv::Mat painted = mask.to_mat();
  const double share = cv::mean(painted)[0] / 255.0;
  if (share > options_.least_share) kept_->paint += weight * (cv::mean(cue, painted)[0] - kept_->paint);
  if (1.0 - share > options_.least_share)
    kept_->floor += weight * (cv::mean(cue, ~painted)[0] - kept_->floor);
}

}  // namespace lineservo::features
