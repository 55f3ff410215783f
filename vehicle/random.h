#pragma once

#include <array>
#include <cstdint>

namespace lineservo::vehicle {

/// The one seeded generator of the simulation: xoshiro256++ (Blackman and Vigna), seeded by SplitMix64, with
/// distributions of our own, because the standard leaves theirs to the library.
class Random {
 public:
  /// Streams of one seed with different ids are independent: each noise source takes its own.
  explicit Random(std::uint64_t seed, std::uint64_t stream = 0);

  std::uint64_t bits();
  /// In [0, 1), 53 bits.
  double uniform();
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Standard normal (Marsaglia's polar method; only sqrt and log).
  double normal();
  double normal(double sigma) { return sigma * normal(); }

 private:
  std::array<std::uint64_t, 4> state_;
  double spare_ = 0.0;
  bool has_spare_ = false;
};

}  // namespace lineservo::vehicle
