#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>

#include "apps/evaluate/degradations.h"

namespace lineservo::apps {
namespace {

constexpr int kSide = 8;
using Block = std::array<float, kSide * kSide>;
using Steps = std::array<int, kSide * kSide>;

constexpr Steps kBrightness = {16, 11, 10, 16, 24,  40,  51,  61,  12, 12, 14, 19, 26,  58,  60,  55,
                               14, 13, 16, 24, 40,  57,  69,  56,  14, 17, 22, 29, 51,  87,  80,  62,
                               18, 22, 37, 56, 68,  109, 103, 77,  24, 35, 55, 64, 81,  104, 113, 92,
                               49, 64, 78, 87, 103, 121, 120, 101, 72, 92, 95, 98, 112, 100, 103, 99};
constexpr Steps kColour = {17, 18, 24, 47, 99, 99, 99, 99, 18, 21, 26, 66, 99, 99, 99, 99,
                           24, 26, 56, 99, 99, 99, 99, 99, 47, 66, 99, 99, 99, 99, 99, 99,
                           99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99,
                           99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99};

// C[k][n] = c(k) cos((2n + 1) k π / 16), orthonormal.
Block cosines() {
  Block C;
  for (int k = 0; k < kSide; ++k)
    for (int n = 0; n < kSide; ++n)
      C[static_cast<std::size_t>(k * kSide + n)] =
          static_cast<float>((k == 0 ? std::sqrt(1.0 / kSide) : std::sqrt(2.0 / kSide)) *
                             std::cos((2 * n + 1) * k * std::numbers::pi / (2 * kSide)));
  return C;
}

Block product(const Block& a, const Block& b) {
  Block c{};
  for (std::size_t i = 0; i < kSide; ++i)
    for (std::size_t k = 0; k < kSide; ++k)
      for (std::size_t j = 0; j < kSide; ++j) c[i * kSide + j] += a[i * kSide + k] * b[k * kSide + j];
  return c;
}

Block transposed(const Block& a) {
  Block t;
  for (std::size_t i = 0; i < kSide; ++i)
    for (std::size_t j = 0; j < kSide; ++j) t[j * kSide + i] = a[i * kSide + j];
  return t;
}

// The scaling of the tables that libjpeg has made common.
Steps scaled(const Steps& table, int quality) {
  const int percent = quality < 50 ? 5000 / quality : 200 - 2 * quality;
  Steps steps;
  for (std::size_t i = 0; i < steps.size(); ++i)
    steps[i] = std::clamp((table[i] * percent + 50) / 100, 1, 255);
  return steps;
}

void round_trip(cv::Mat& plane, const Steps& steps) {
  static const Block C = cosines();
  static const Block Ct = transposed(C);
  Block block;
  for (int y = 0; y + kSide <= plane.rows; y += kSide) {
    for (int x = 0; x + kSide <= plane.cols; x += kSide) {
      for (int r = 0; r < kSide; ++r)
        for (int c = 0; c < kSide; ++c)
          block[static_cast<std::size_t>(r * kSide + c)] =
              static_cast<float>(plane.ptr(y + r)[x + c]) - 128.0F;
      block = product(product(C, block), Ct);
      for (std::size_t i = 0; i < block.size(); ++i) {
        const auto step = static_cast<float>(steps[i]);
        block[i] = step * std::nearbyint(block[i] / step);
      }
      block = product(product(Ct, block), C);
      for (int r = 0; r < kSide; ++r)
        for (int c = 0; c < kSide; ++c)
          plane.ptr(y + r)[x + c] =
              cv::saturate_cast<std::uint8_t>(block[static_cast<std::size_t>(r * kSide + c)] + 128.0F);
    }
  }
}

}  // namespace

void jpeg_blocks(cv::Mat& bgr, int quality) {
  cv::Mat ycc, planes[3];
  cv::cvtColor(bgr, ycc, cv::COLOR_BGR2YCrCb);
  cv::split(ycc, planes);
  round_trip(planes[0], scaled(kBrightness, quality));
  for (int c = 1; c < 3; ++c) {
    cv::Mat half;
    cv::resize(planes[c], half, cv::Size((bgr.cols + 1) / 2, (bgr.rows + 1) / 2), 0.0, 0.0, cv::INTER_AREA);
    round_trip(half, scaled(kColour, quality));
    cv::resize(half, planes[c], bgr.size(), 0.0, 0.0, cv::INTER_LINEAR);
  }
  cv::merge(planes, 3, ycc);
  cv::cvtColor(ycc, bgr, cv::COLOR_YCrCb2BGR);
}

}  // namespace lineservo::apps
