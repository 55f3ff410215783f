#include "features/mask/bilinear_axis.h"

#include <algorithm>
#include <cmath>

namespace lineservo::features {
namespace {

constexpr float kOne = 2048.0F;  // 11 fractional bits

struct Position {
  int index = 0;
  float fraction = 0.0F;
};

// Pixel centres: x_in = (x_out + ½) · input / output − ½, in the precision in which OpenCV evaluates it.
Position position(int sample, int input, int output) {
  const double scale = 1.0 / (static_cast<double>(output) / input);
  const auto x = static_cast<float>((sample + 0.5) * scale - 0.5);
  const int index = static_cast<int>(std::floor(x));
  return {index, x - static_cast<float>(index)};
}

std::int16_t weight(float share) {
  return static_cast<std::int16_t>(std::lrint(share * kOne));
}

BilinearTap tap(Position p, int input) {
  const int last = input - 1;
  return {std::clamp(p.index, 0, last), std::clamp(p.index + 1, 0, last), weight(1.0F - p.fraction),
          weight(p.fraction)};
}

}  // namespace

std::vector<BilinearTap> bilinear_columns(int input, int output) {
  std::vector<BilinearTap> taps;
  for (int i = 0; i < output; ++i) {
    const Position p = position(i, input, output);
    const bool outside = p.index < 0 || p.index >= input - 1;
    taps.push_back(tap(outside ? Position{std::clamp(p.index, 0, input - 1), 0.0F} : p, input));
  }
  return taps;
}

std::vector<BilinearTap> bilinear_rows(int input, int output) {
  std::vector<BilinearTap> taps;
  taps.reserve(static_cast<std::size_t>(output));
  for (int i = 0; i < output; ++i) taps.push_back(tap(position(i, input, output), input));
  return taps;
}

}  // namespace lineservo::features
