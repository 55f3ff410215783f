#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "features/mask/bilinear_axis.h"
#include "features/mask/frame_classifier.h"
#include "features/mask/red_sector_test.h"
#include "features/mask/vector_color_test.h"

namespace lineservo::features {

/// 32 pixels at a time, for processors with AVX2.
///
/// A group of 32 output pixels is held in two vectors of words a channel, A = pixels 0–7 and 16–23 and
/// B = 8–15 and 24–31, because packing A and B to bytes (which works in halves of a vector) then yields the
/// pixels in order, and the sign bits of those bytes are 32 bits of the mask.
class Avx2Classifier : public FrameClassifier {
 public:
  Avx2Classifier(const SegmenterOptions& options, const RedSectorTest& test, cv::Size frame_size);

  int classify(const cv::Mat& frame, PackedMask& path, PackedMask& marker) override;

  /// How one vector of 16 output pixels gathers its inputs: eight pairs of neighbouring pixels, each from
  /// 16 bytes read at one place, or 8 bytes at two places when the two lie too far apart.
  struct alignas(32) Gather {
    std::array<std::int32_t, 8> first{}, second{};            ///< byte offsets in the input row
    std::array<std::array<std::uint8_t, 16>, 8> order{};      ///< byte shuffle to B0B1 G0G1 R0R1, two pixels
    std::array<std::int8_t, 32> weight_high{}, weight_low{};  ///< (w0, w1) = 64 · high + low
  };

 private:
  const std::int16_t* resized_row(const cv::Mat& frame, int y);

  RedSectorTest test_;
  vector_test::PlainLimits limits_;
  int width_;
  bool pairs_are_near_;
  std::vector<Gather> gathers_;
  std::vector<BilinearTap> rows_;
  std::array<std::vector<std::int16_t>, 2> cache_;
  std::array<int, 2> cached_y_{};
};

}  // namespace lineservo::features
