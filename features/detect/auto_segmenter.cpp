#include "features/detect/auto_segmenter.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "features/detect/stripe_evidence.h"
#include "features/mask/mask_filter.h"

namespace lineservo::features {
namespace {

constexpr double kFullQuantile = 0.995;  // a line covers more of the image than the rest
constexpr double kPlain = 0.35;          // full contrast of paint that nobody can miss, 1 = 255
constexpr double kPlainBlack = 0.55;     // and of black: shadows reach 0.5
constexpr double kLevels = 255.0;

bool is_hue(LineColor color) {
  return color == LineColor::yellow || color == LineColor::red;
}

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
    if (auto best = best_of(color, bgr, finder)) found.push_back(std::move(*best));
  std::stable_sort(found.begin(), found.end(),
                   [](const ColorChoice& a, const ColorChoice& b) { return a.evidence > b.evidence; });
  return found;
}

std::optional<ColorChoice> AutoSegmenter::best_of(LineColor color, const cv::Mat& bgr,
                                                  WedgeLineFinder& finder) const {
  std::optional<ColorChoice> best;
  for (const ContrastReach& reach : options_.reaches)
    try_thresholds(color, color_contrast(bgr, color, reach), finder, best);
  return best;
}

void AutoSegmenter::try_thresholds(LineColor color, const cv::Mat& contrast, WedgeLineFinder& finder,
                                   std::optional<ColorChoice>& best) const {
  const PaintContrast paint{contrast, full_contrast(contrast), least_width(color), options_.largest_share};
  if (paint.full < kLevels * least_contrast(color)) return;
  for (const double threshold : options_.thresholds) {
    PackedMask mask = thresholded(contrast, threshold * paint.full);
    WedgeLines seen = finder.find(mask);
    const double evidence = trust(color, paint.full) * judge(mask, paint, finder.geometry(), seen);
    if (evidence < std::max(options_.min_evidence, best ? best->evidence : 0.0)) continue;
    best = ColorChoice{color, evidence, std::move(mask), std::move(seen)};
  }
}

double AutoSegmenter::least_contrast(LineColor color) const {
  return is_hue(color) ? options_.least_hue_contrast : options_.least_lightness_contrast;
}

double AutoSegmenter::least_width(LineColor color) const {
  if (is_hue(color)) return options_.least_hue_width;
  return color == LineColor::white ? options_.least_white_width : options_.least_black_width;
}

double AutoSegmenter::trust(LineColor color, double full_contrast) const {
  const double plain = color == LineColor::black ? kPlainBlack : kPlain;
  return (is_hue(color) ? 1.0 : options_.lightness_trust) * std::min(1.0, full_contrast / (kLevels * plain));
}

}  // namespace lineservo::features
