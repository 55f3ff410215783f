#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "features/mask/bilinear_axis.h"
#include "features/mask/frame_classifier.h"
#include "features/mask/red_sector_test.h"
#include "features/mask/vector_color_test.h"

namespace lineservo::features {

/// 64 pixels at a time, for processors with AVX-512 and its byte permutations.
///
/// A step resizes 16 output pixels from 128 bytes of the input row. A group of four steps, 64 pixels, is held
/// as four vectors of 16 words of blue and 16 of green, and two of 32 words of red.
class Avx512Classifier : public FrameClassifier {
 public:
  /// Whether 16 neighbouring output pixels always come from 128 bytes, as down to a scale of 1 : 2.6.
  static bool fits(const SegmenterOptions& options, cv::Size frame_size);

  /// For a size that fits.
  Avx512Classifier(const SegmenterOptions& options, const RedSectorTest& test, cv::Size frame_size);

  int classify(const cv::Mat& frame, PackedMask& path, PackedMask& marker) override;

  /// How the 16 output pixels of a step gather their inputs.
  struct alignas(64) Gather {
    std::array<std::uint8_t, 64> blue_green{};  ///< bytes of the 128: B0B1 of each pixel, then G0G1
    std::array<std::uint8_t, 64> red{};         ///< R0R1 of each pixel; the upper half is not used
    std::array<std::int8_t, 32> weight_high{}, weight_low{};  ///< (w0, w1) = 64 · high + low
    std::int32_t first = 0;                                   ///< of the 128 bytes in the input row
  };

 private:
  const std::int16_t* resized_row(const cv::Mat& frame, int y);

  RedSectorTest test_;
  vector_test::PlainLimits limits_;
  int width_;
  std::vector<Gather> gathers_;
  std::vector<BilinearTap> rows_;
  std::array<std::vector<std::int16_t>, 2> cache_;
  std::array<int, 2> cached_y_{};
};

}  // namespace lineservo::features
