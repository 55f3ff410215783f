#pragma once

#include <cstdint>
#include <vector>

#include "features/mask/color_svm.h"
#include "features/mask/segmenter.h"

namespace lineservo::features {

/// Margins of the support vector machine: positive is paint.
struct SvmSegmenterOptions {
  double seed = 0.5;   ///< margins: surely paint
  double grow = -0.5;  ///< margins: paint where it touches paint; not above seed
};

/// Colour SVM and region growing (grid §IV-A): from the pixels that are surely paint through their neighbours
/// that may be, so that shade and glare on the line belong to it and like colours elsewhere do not. The
/// machine is asked once for each of 32³ colours, not for each pixel.
class SvmSegmenter : public Segmenter {
 public:
  /// Throws std::invalid_argument when seed is below grow.
  explicit SvmSegmenter(const ColorSvm& svm, const SvmSegmenterOptions& options = {});

  PackedMask segment(const cv::Mat& image, cv::Size mask_size) override;

 private:
  enum Verdict : std::uint8_t { kFloor = 0, kMaybe = 1, kSurely = 2 };

  std::uint8_t verdict(const cv::Vec3b& bgr) const;

  std::vector<std::uint8_t> verdicts_;
};

}  // namespace lineservo::features
