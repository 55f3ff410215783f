#include "features/line/thinning.h"

#include <bit>

namespace lineservo::features {
namespace {

using Word = PackedMask::Word;

// Which bits are set in exactly one, or in at least two, of the words added.
struct OnceOrMore {
  Word once = 0, twice = 0;

  void add(Word bits) {
    twice |= once & bits;
    once |= bits;
  }
};

// P2…P9 of the paper for 64 pixels: clockwise from the one above.
struct Neighbours {
  Word p[8];
};

Neighbours neighbours(const Word* above, const Word* here, const Word* below) {
  const auto right = [](const Word* w) { return (w[0] >> 1) | (w[1] << 63); };
  const auto left = [](const Word* w) { return (w[0] << 1) | (w[-1] >> 63); };
  return {
      {above[0], right(above), right(here), right(below), below[0], left(below), left(here), left(above)}};
}

// Conditions (a) to (d): two to six neighbours, one transition from 0 to 1 around the pixel, and
// P2 P4 P6 = P4 P6 P8 = 0 in the first, P2 P4 P8 = P2 P6 P8 = 0 in the second sub-iteration.
Word deletable(const Neighbours& n, int parity) {
  OnceOrMore set, clear, transitions;
  for (int k = 0; k < 8; ++k) {
    set.add(n.p[k]);
    clear.add(~n.p[k]);
    transitions.add(~n.p[k] & n.p[(k + 1) & 7]);
  }
  const Word p2 = n.p[0], p4 = n.p[2], p6 = n.p[4], p8 = n.p[6];
  const Word kept = parity == 0 ? (p4 & p6 & (p2 | p8)) : (p2 & p8 & (p4 | p6));
  return set.twice & clear.twice & transitions.once & ~transitions.twice & ~kept;
}

}  // namespace

void Thinner::thin(PackedMask& mask) {
  reset(mask);
  bool changed = true;
  while (changed) {
    const bool first = pass(mask, 0);
    const bool second = pass(mask, 1);
    changed = first || second;
  }
}

void Thinner::reset(const PackedMask& mask) {
  height_ = mask.height();
  words_per_row_ = mask.words_per_row();
  groups_ = (words_per_row_ + 63) / 64;
  // A word of zeros before and after, as the mask's own rows have.
  nothing_.assign(static_cast<std::size_t>(words_per_row_) + 2, 0);
  for (auto& awake : awake_) awake.assign(static_cast<std::size_t>(height_ * groups_), 0);
  for (int y = 0; y < height_; ++y) {
    const auto row = mask.row(y);
    for (int w = 0; w < words_per_row_; ++w)
      if (row[static_cast<std::size_t>(w)] != 0)
        for (auto& awake : awake_)
          awake[static_cast<std::size_t>(y * groups_ + w / 64)] |= std::uint64_t{1} << (w % 64);
  }
}

bool Thinner::pass(PackedMask& mask, int parity) {
  deletions_.clear();
  const Word* nothing = nothing_.data() + 1;
  for (int y = 0; y < height_; ++y) {
    for (int group = 0; group < groups_; ++group) {
      std::uint64_t& awake = awake_[parity][static_cast<std::size_t>(y * groups_ + group)];
      if (awake == 0) continue;
      const Word* here = mask.row(y).data();
      const Word* above = y > 0 ? mask.row(y - 1).data() : nothing;
      const Word* below = y + 1 < height_ ? mask.row(y + 1).data() : nothing;
      for (std::uint64_t left = awake; left != 0; left &= left - 1) {
        const int w = group * 64 + std::countr_zero(left);
        if (here[w] == 0) continue;
        const Word bits = here[w] & deletable(neighbours(above + w, here + w, below + w), parity);
        if (bits != 0) deletions_.push_back({y, w, bits});
      }
      awake = 0;
    }
  }
  apply(mask);
  return !deletions_.empty();
}

void Thinner::apply(PackedMask& mask) {
  for (const Deletion& deletion : deletions_) {
    mask.row(deletion.row)[static_cast<std::size_t>(deletion.word)] &= ~deletion.bits;
    for (int row = deletion.row - 1; row <= deletion.row + 1; ++row) {
      wake(row, deletion.word);
      if (deletion.bits & 1) wake(row, deletion.word - 1);
      if (deletion.bits >> 63) wake(row, deletion.word + 1);
    }
  }
}

void Thinner::wake(int row, int word) {
  if (row < 0 || row >= height_ || word < 0 || word >= words_per_row_) return;
  for (auto& awake : awake_)
    awake[static_cast<std::size_t>(row * groups_ + word / 64)] |= std::uint64_t{1} << (word % 64);
}

}  // namespace lineservo::features
