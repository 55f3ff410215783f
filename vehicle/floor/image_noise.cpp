#include "vehicle/floor/image_noise.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "vehicle/floor/clones.h"
#include "vehicle/random.h"

namespace lineservo::vehicle {
namespace {

// A row of 640 pixels meets its neighbour's part of the pool, shifted, with a chance of 1 in 34.
constexpr std::size_t kPoolSize = std::size_t{1} << 17;
constexpr std::size_t kChunk = 2048;
constexpr std::uint64_t kNoiseStream = 0x6e6f697365;

std::int8_t quantised(double levels) {
  return static_cast<std::int8_t>(std::clamp(std::lround(levels), -127L, 127L));
}

// SplitMix64's mixing of a counter.
std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

LINESERVO_CLONES void add_saturated(const std::int8_t* noise, std::size_t count, std::uint8_t* values) {
  for (std::size_t i = 0; i < count; ++i) {
    const auto sum = static_cast<std::int16_t>(values[i] + noise[i]);
    const std::int16_t floored = sum < 0 ? std::int16_t{0} : sum;
    values[i] = static_cast<std::uint8_t>(floored > 255 ? std::int16_t{255} : floored);
  }
}

}  // namespace

ImageNoise::ImageNoise(double sigma, std::uint64_t seed) : seed_(seed) {
  if (!(sigma >= 0.0 && sigma <= 0.1)) throw std::invalid_argument("image noise: sigma must be 0 to 0.1");
  if (sigma == 0.0) return;
  Random random(seed, kNoiseStream);
  pool_.resize(kPoolSize);
  for (std::int8_t& value : pool_) value = quantised(random.normal(255.0 * sigma));
}

void ImageNoise::add(std::int64_t frame, cv::Mat& bgr) const {
  if (pool_.empty()) return;
  const std::size_t row_size = static_cast<std::size_t>(bgr.cols) * bgr.elemSize();
  std::uint64_t state = mixed(seed_ ^ mixed(static_cast<std::uint64_t>(frame)));
  for (int row = 0; row < bgr.rows; ++row)
    for (std::size_t done = 0; done < row_size; done += kChunk) {
      const std::size_t count = std::min(kChunk, row_size - done);
      state = mixed(state);
      add_saturated(pool_.data() + state % (kPoolSize - kChunk), count, bgr.ptr(row) + done);
    }
}

}  // namespace lineservo::vehicle
