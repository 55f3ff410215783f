#include "features/junction/code_filter.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace lineservo::features {

CodeFilter::CodeFilter(int window) : window_(static_cast<std::size_t>(window)) {
  if (window < 1 || window > static_cast<int>(kMaxWindow) || window % 2 == 0)
    throw std::invalid_argument("code filter: the window must be 1, 3, 5, 7 or 9 frames, got " +
                                std::to_string(window));
}

CodeReading CodeFilter::update(JunctionCode raw, bool line_ends_ahead) {
  const JunctionCode held = raw == JunctionCode::unrecognised ? smoothed_ : raw;
  push(held);
  smoothed_ = mode();
  return {raw, held, smoothed_, line_ends_ahead && held == smoothed_};
}

void CodeFilter::reset() {
  *this = CodeFilter(static_cast<int>(window_));
}

void CodeFilter::push(JunctionCode held) {
  if (size_ == window_)
    std::shift_left(held_.begin(), held_.begin() + window_, 1);
  else
    ++size_;
  held_[size_ - 1] = held;
}

JunctionCode CodeFilter::mode() const {
  std::array<int, kJunctionCodes> votes{};
  for (std::size_t i = 0; i < size_; ++i) ++votes[static_cast<std::size_t>(held_[i])];
  const auto votes_of = [&](JunctionCode code) { return votes[static_cast<std::size_t>(code)]; };
  // max_element returns the first of equals, and the oldest comes first.
  return *std::max_element(held_.begin(), held_.begin() + size_,
                           [&](JunctionCode a, JunctionCode b) { return votes_of(a) < votes_of(b); });
}

}  // namespace lineservo::features
