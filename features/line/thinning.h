#pragma once

#include <cstdint>
#include <vector>

#include "features/mask/packed_mask.h"

namespace lineservo::features {

/// Zhang–Suen thinning (Comm. ACM 27(3), 1984; grid §IV-B2): pixel for pixel the textbook's result, outside
/// the mask background, but 64 pixels at a time and only where something has changed since the last look.
/// Keeps its buffers from call to call.
class Thinner {
 public:
  /// Replaces a mask by its skeleton.
  void thin(PackedMask& mask);

 private:
  /// Pixels of a word that a sub-iteration takes away.
  struct Deletion {
    int row, word;
    PackedMask::Word bits;
  };

  void reset(const PackedMask& mask);
  /// One parallel sub-iteration, 0 or 1; false when it takes nothing away.
  bool pass(PackedMask& mask, int parity);
  void apply(PackedMask& mask);
  void wake(int row, int word);

  int height_ = 0, groups_ = 0, words_per_row_ = 0;
  /// For each parity and row, a bit for each word that must be looked at.
  std::vector<std::uint64_t> awake_[2];
  std::vector<PackedMask::Word> nothing_;
  std::vector<Deletion> deletions_;
};

}  // namespace lineservo::features
