#include "features/mask/portable_classifier.h"

#include <algorithm>

namespace lineservo::features {
namespace {

// Vertical half of the bilinear sum: both products keep their high 16 bits, then 2 fractional bits round off.
int blend(std::int16_t upper, std::int16_t lower, BilinearTap tap) {
  return (((upper * tap.w0) >> 16) + ((lower * tap.w1) >> 16) + 2) >> 2;
}

}  // namespace

PortableClassifier::PortableClassifier(const SegmenterOptions& options, cv::Size frame_size)
    : classes_(options),
      columns_(bilinear_columns(frame_size.width, options.width_px)),
      rows_(bilinear_rows(frame_size.height, options.height_px)) {
  cache_.fill(Row(columns_.size() * 3));
}

int PortableClassifier::classify(const cv::Mat& frame, PackedMask& path, PackedMask& marker) {
  cached_y_.fill(-1);
  int marker_pixels = 0;
  for (std::size_t y = 0; y < rows_.size(); ++y) {
    const Row& upper = resized_row(frame, rows_[y].i0);
    const Row& lower = resized_row(frame, rows_[y].i1);
    marker_pixels +=
        classify_row(upper, lower, rows_[y], path.row(static_cast<int>(y)), marker.row(static_cast<int>(y)));
  }
  return marker_pixels;
}

// Neighbouring rows differ in parity, so that the two of a blend never evict each other.
const PortableClassifier::Row& PortableClassifier::resized_row(const cv::Mat& frame, int y) {
  const auto slot = static_cast<std::size_t>(y % 2);
  if (cached_y_[slot] != y) {
    resize_columns(frame.ptr<std::uint8_t>(y), cache_[slot]);
    cached_y_[slot] = y;
  }
  return cache_[slot];
}

// Horizontal half of the bilinear sum: 11 fractional bits, of which 7 are kept.
void PortableClassifier::resize_columns(const std::uint8_t* pixels, Row& row) const {
  auto* out = row.data();
  for (const BilinearTap& tap : columns_) {
    const std::uint8_t* left = pixels + 3 * tap.i0;
    const std::uint8_t* right = pixels + 3 * tap.i1;
    for (int channel = 0; channel < 3; ++channel)
      *out++ = static_cast<std::int16_t>((left[channel] * tap.w0 + right[channel] * tap.w1) >> 4);
  }
}

int PortableClassifier::classify_row(const Row& upper, const Row& lower, BilinearTap tap,
                                     std::span<PackedMask::Word> path,
                                     std::span<PackedMask::Word> marker) const {
  std::fill(path.begin(), path.end(), PackedMask::Word{0});
  std::fill(marker.begin(), marker.end(), PackedMask::Word{0});
  int marker_pixels = 0;
  for (std::size_t x = 0; x < columns_.size(); ++x) {
    const std::int16_t* u = &upper[3 * x];
    const std::int16_t* l = &lower[3 * x];
    const std::uint8_t set =
        classes_.of(blend(u[0], l[0], tap), blend(u[1], l[1], tap), blend(u[2], l[2], tap));
    path[x / 64] |= PackedMask::Word{(set & kPath) != 0} << (x % 64);
    marker[x / 64] |= PackedMask::Word{(set & kMarker) != 0} << (x % 64);
    marker_pixels += (set & kMarker) != 0;
  }
  return marker_pixels;
}

}  // namespace lineservo::features
