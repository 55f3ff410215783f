#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

namespace lineservo::vehicle {

/// Additive normal noise, independent per channel, saturated to 8 bits. Values come from a pool drawn once;
/// every row of every frame starts at its own place in the pool, a hash of (seed, frame, row). The same seed
/// and frame index give the same noise.
class ImageNoise {
 public:
  /// σ as a share of full scale, 0 … 0.1. Throws std::invalid_argument outside.
  ImageNoise(double sigma, std::uint64_t seed);

  /// Adds the noise of a frame to an 8-bit BGR image.
  void add(std::int64_t frame, cv::Mat& bgr) const;

 private:
  std::vector<std::int8_t> pool_;  ///< empty when σ = 0
  std::uint64_t seed_;
};

}  // namespace lineservo::vehicle
