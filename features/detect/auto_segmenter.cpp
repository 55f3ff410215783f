#include "features/detect/auto_segmenter.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "features/detect/stripe_evidence.h"
#include "features/mask/mask_filter.h"

namespace lineservo::features {
namespace {

constexpr double kFullQuantile = 0.995;  // a line covers more of the image than the rest
constexpr ContrastReach kWholePicture{.share = 1.0, .floor_share = 0.25};
constexpr double kLevels = 255.0;

/// The contrast that all but the strongest half per cent of the pixels stay under.
double full_contrast(const cv::Mat& contrast) {
  std::vector<std::uint8_t> levels(contrast.begin<std::uint8_t>(), contrast.end<std::uint8_t>());
  const auto at = levels.begin() + static_cast<std::ptrdiff_t>(kFullQuantile * double(levels.size() - 1));
  std::nth_element(levels.begin(), at, levels.end());
  return *at;
}

PackedMask thresholded(const cv::Mat& contrast, double threshold) {
  const cv::Mat above = contrast > threshold;
  PackedMask mask = PackedMask::from_mat(above);
  MaskFilter filter(mask.width(), mask.height());
  filter.median_5x5(mask, mask);
  filter.close_5x5(mask, mask);
  return mask;
}

}  // namespace

AutoSegmenter::AutoSegmenter(const AutoSegmenterOptions& options) : options_(options) {
  if (options.colors.empty() || options.reaches.empty() || options.thresholds.empty())
    throw std::invalid_argument("auto segmenter: colors, reaches and thresholds must not be empty");
}

PackedMask AutoSegmenter::segment(const cv::Mat& image, cv::Size mask_size) {
  require_segmentable(image, mask_size);
  auto found = choices(image, assumed_geometry(mask_size.width, mask_size.height));
  color_.reset();
  evidence_ = 0.0;
  if (found.empty()) return {mask_size.width, mask_size.height};
  color_ = found.front().color;
  evidence_ = found.front().evidence;
  return std::move(found.front().mask);
}

std::vector<ColorChoice> AutoSegmenter::choices(const cv::Mat& image, const MaskGeometry& geometry) const {
  const cv::Size mask_size(geometry.width_px(), geometry.height_px());
  require_segmentable(image, mask_size);
  const cv::Mat bgr = resized_bgr(image, mask_size);
  WedgeLineFinder finder(geometry);
  std::vector<ColorChoice> found;
  for (const LineColor color : options_.colors)
    if (auto best = best_of(bar_of(color, image.channels() == 3), bgr, finder))
      found.push_back(std::move(*best));
  std::stable_sort(found.begin(), found.end(),
                   [](const ColorChoice& a, const ColorChoice& b) { return a.evidence > b.evidence; });
  return found;
}

// Between shadows and beside dark joints and planks the floor is lighter than the floor around it; paint is
// lighter, or darker, than the floor of the whole picture as well.
std::optional<ColorChoice> AutoSegmenter::best_of(const Bar& bar, const cv::Mat& bgr,
                                                  WedgeLineFinder& finder) const {
  const double most =
      has_hue(bar.color) ? kLevels : full_contrast(color_contrast(bgr, bar.color, kWholePicture));
  std::optional<ColorChoice> best;
  for (const ContrastReach& reach : options_.reaches) {
    const cv::Mat contrast = color_contrast(bgr, bar.color, reach);
    const PaintContrast paint{contrast, full_contrast(contrast), bar.least_width, options_.largest_share};
    if (paint.full < kLevels * bar.least_contrast) continue;
    try_thresholds(bar, paint, trust(bar, std::min(paint.full, most)), finder, best);
  }
  return best;
}

void AutoSegmenter::try_thresholds(const Bar& bar, const PaintContrast& paint, double trusted,
                                   WedgeLineFinder& finder, std::optional<ColorChoice>& best) const {
  if (trusted < options_.min_evidence) return;
  for (const double threshold : options_.thresholds) {
    PackedMask mask = thresholded(paint.contrast, threshold * paint.full);
    WedgeLines seen = finder.find(mask);
    const double evidence = trusted * judge(mask, paint, finder.geometry(), seen);
    if (evidence < std::max(options_.min_evidence, best ? best->evidence : 0.0)) continue;
    best = ColorChoice{bar.color, evidence, std::move(mask), std::move(seen)};
  }
}

AutoSegmenter::Bar AutoSegmenter::bar_of(LineColor color, bool picture_has_hues) const {
  const AutoSegmenterOptions& o = options_;
  if (has_hue(color)) return {color, o.least_hue_contrast, o.plain_hue, o.least_hue_width};
  const double plain = color == LineColor::black ? o.plain_black : o.plain_white;
  return {color, o.least_lightness_contrast, picture_has_hues ? plain : o.plain_grey,
          o.least_lightness_width};
}

// Hues are rare on a floor, so that a pale one counts in proportion. Light and shade are everywhere: what is
// barely lighter or darker than the floor counts for nothing, and for more the plainer it is.
double AutoSegmenter::trust(const Bar& bar, double full_contrast) const {
  const double full = full_contrast / kLevels;
  if (has_hue(bar.color)) return std::min(1.0, full / bar.plain_contrast);
  const double above = (full - bar.least_contrast) / (bar.plain_contrast - bar.least_contrast);
  return options_.lightness_trust * std::clamp(above, 0.0, 1.0);
}

}  // namespace lineservo::features
