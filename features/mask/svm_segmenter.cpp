#include "features/mask/svm_segmenter.h"

#include <stdexcept>

namespace lineservo::features {
namespace {

constexpr int kDropped_bits = 3;  // of each channel
constexpr int kSteps = 256 >> kDropped_bits;

std::size_t index_of(int b, int g, int r) {
  return static_cast<std::size_t>(((b >> kDropped_bits) * kSteps + (g >> kDropped_bits)) * kSteps +
                                  (r >> kDropped_bits));
}

std::vector<cv::Vec3b> middle_of_every_step() {
  std::vector<cv::Vec3b> colors;
  const auto middle = [](int step) {
    return static_cast<std::uint8_t>((step << kDropped_bits) + (1 << kDropped_bits) / 2);
  };
  for (int b = 0; b < kSteps; ++b)
    for (int g = 0; g < kSteps; ++g)
      for (int r = 0; r < kSteps; ++r) colors.emplace_back(middle(b), middle(g), middle(r));
  return colors;
}

/// Takes every pixel of at least `least` that hangs together, side or corner, with one of `seed`.
PackedMask grown(const cv::Mat& verdicts, std::uint8_t seed, std::uint8_t least) {
  PackedMask mask(verdicts.cols, verdicts.rows);
  std::vector<cv::Point> front;
  const auto take = [&](int x, int y) {
    mask.set(x, y);
    front.emplace_back(x, y);
  };
  for (int y = 0; y < verdicts.rows; ++y)
    for (int x = 0; x < verdicts.cols; ++x)
      if (verdicts.at<std::uint8_t>(y, x) >= seed) take(x, y);
  while (!front.empty()) {
    const cv::Point at = front.back();
    front.pop_back();
    for (int y = std::max(at.y - 1, 0); y <= std::min(at.y + 1, verdicts.rows - 1); ++y)
      for (int x = std::max(at.x - 1, 0); x <= std::min(at.x + 1, verdicts.cols - 1); ++x)
        if (verdicts.at<std::uint8_t>(y, x) >= least && !mask.at(x, y)) take(x, y);
  }
  return mask;
}

}  // namespace

SvmSegmenter::SvmSegmenter(const ColorSvm& svm, const SvmSegmenterOptions& options) {
  if (!(options.grow <= options.seed))
    throw std::invalid_argument("SVM segmenter: grow must not be above seed");
  for (const double decision : svm.decisions(middle_of_every_step()))
    verdicts_.push_back(decision >= options.seed ? kSurely : decision >= options.grow ? kMaybe : kFloor);
}

std::uint8_t SvmSegmenter::verdict(const cv::Vec3b& bgr) const {
  return verdicts_[index_of(bgr[0], bgr[1], bgr[2])];
}

PackedMask SvmSegmenter::segment(const cv::Mat& image, cv::Size mask_size) {
  require_segmentable(image, mask_size);
  const cv::Mat bgr = resized_bgr(image, mask_size);
  cv::Mat verdicts(bgr.size(), CV_8UC1);
  for (int y = 0; y < bgr.rows; ++y)
    for (int x = 0; x < bgr.cols; ++x) verdicts.at<std::uint8_t>(y, x) = verdict(bgr.at<cv::Vec3b>(y, x));
  return grown(verdicts, kSurely, kMaybe);
}

}  // namespace lineservo::features
