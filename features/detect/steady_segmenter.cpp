#include "features/detect/steady_segmenter.h"

#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "features/mask/mask_filter.h"

namespace lineservo::features {

SteadySegmenter::SteadySegmenter(const SteadyOptions& options) : options_(options), search_(options.search) {
  if (options.agreeing_frames < 1 || options.forgiven_frames < 1)
    throw std::invalid_argument("steady segmenter: the counts of frames must be at least 1");
  const auto is_share = [](double value) { return value > 0.0 && value < 1.0; };
  if (!is_share(options.threshold) || !is_share(options.renewal) || !is_share(options.least_share))
    throw std::invalid_argument(
        "steady segmenter: threshold, renewal and least share must lie between 0 and 1");
}

std::optional<LineColor> SteadySegmenter::color() const {
  return kept_ ? std::optional(kept_->color) : std::nullopt;
}

PackedMask SteadySegmenter::segment(const cv::Mat& image, cv::Size mask_size) {
  require_segmentable(image, mask_size);
  const cv::Mat bgr = resized_bgr(image, mask_size);
  return kept_ ? kept_paint(bgr) : search(bgr, mask_size);
}

PackedMask SteadySegmenter::search(const cv::Mat& bgr, cv::Size mask_size) {
  PackedMask mask = search_.segment(bgr, mask_size);
  const bool sure = search_.color() && search_.evidence() >= options_.sure;
  agreeing_ = sure && search_.color() == candidate_ ? agreeing_ + 1 : int{sure};
  candidate_ = sure ? search_.color() : std::nullopt;
  if (agreeing_ < options_.agreeing_frames) return mask;
  kept_ = Paint{.color = *search_.color()};
  renew(color_cue(bgr, kept_->color), mask, 1.0);
  without_paint_ = 0;
  return mask;
}

PackedMask SteadySegmenter::kept_paint(const cv::Mat& bgr) {
  const cv::Mat cue = color_cue(bgr, kept_->color);
  const double limit = kept_->floor + options_.threshold * (kept_->paint - kept_->floor);
  const cv::Mat is_paint = kept_->paint > kept_->floor ? cv::Mat(cue > limit) : cv::Mat(cue < limit);
  PackedMask mask = PackedMask::from_mat(is_paint);
  MaskFilter filter(mask.width(), mask.height());
  filter.median_5x5(mask, mask);
  filter.close_5x5(mask, mask);
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
