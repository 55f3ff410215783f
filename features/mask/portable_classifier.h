#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "features/mask/bilinear_axis.h"
#include "features/mask/color_classes.h"
#include "features/mask/frame_classifier.h"

namespace lineservo::features {

/// Plain C++, for any processor and any colour bounds.
class PortableClassifier : public FrameClassifier {
 public:
  PortableClassifier(const SegmenterOptions& options, cv::Size frame_size);

  int classify(const cv::Mat& frame, PackedMask& path, PackedMask& marker) override;

 private:
  using Row = std::vector<std::int16_t>;  // BGR, interleaved, 7 fractional bits

  void resize_columns(const std::uint8_t* pixels, Row& row) const;
  const Row& resized_row(const cv::Mat& frame, int y);
  int classify_row(const Row& upper, const Row& lower, BilinearTap tap, std::span<PackedMask::Word> path,
                   std::span<PackedMask::Word> marker) const;

  ColorClasses classes_;
  std::vector<BilinearTap> columns_, rows_;
  std::array<Row, 2> cache_;  // the two input rows last resized: even rows in the first, odd in the second
  std::array<int, 2> cached_y_{};
};

}  // namespace lineservo::features
