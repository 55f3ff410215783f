#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace lineservo::features {

/// 128 pixels in one register. Every x86-64 has such registers; on other processors the compiler takes two
/// words, with the same result.
using Block = std::uint64_t __attribute__((vector_size(16)));
inline constexpr std::size_t kBlockWords = 2;

inline Block load_block(const std::uint64_t* words) {
  Block block;
  std::memcpy(&block, words, sizeof block);
  return block;
}

inline void store_block(std::uint64_t* words, Block block) {
  std::memcpy(words, &block, sizeof block);
}

/// a + b + c = sum + 2 carry, for each bit by itself.
struct BitSum {
  Block sum, carry;
};

inline BitSum add(Block a, Block b, Block c) {
  const Block half = a ^ b;
  return {half ^ c, (a & b) | (half & c)};
}

}  // namespace lineservo::features
