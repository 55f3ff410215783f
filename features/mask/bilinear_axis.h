#pragma once

#include <cstdint>
#include <vector>

namespace lineservo::features {

/// Where one output sample of a bilinear resize reads, along one axis: sample = w0 · in[i0] + w1 · in[i1],
/// weights with 11 fractional bits.
struct BilinearTap {
  int i0 = 0, i1 = 0;
  std::int16_t w0 = 0, w1 = 0;
};

/// The two axes differ at the border: columns give the clamped sample full weight, rows clamp both indices
/// and keep the weights. This is how cv::resize(INTER_LINEAR) treats 8-bit images, bit for bit.
std::vector<BilinearTap> bilinear_columns(int input, int output);
std::vector<BilinearTap> bilinear_rows(int input, int output);

}  // namespace lineservo::features
