#pragma once

#include <array>
#include <cstddef>

#include "features/frame_features.h"
#include "features/junction/junction_code.h"

namespace lineservo::features {

/// The temporal filter of topology §2.5. Hold: J1 repeats the last smoothed code. Window: the code that is
/// most frequent among the last N held ones; of several, the one that came first within the window.
class CodeFilter {
 public:
  static constexpr int kDefaultWindow = 5;

  /// N is 1, 3, 5, 7 or 9, else std::invalid_argument.
  explicit CodeFilter(int window = kDefaultWindow);

  /// One frame further. Of the line's end a frame that reads otherwise than the window says nothing.
  CodeReading update(JunctionCode raw, bool line_ends_ahead = false);

  /// Forgets all frames: the next J1 is held as J1.
  void reset();

 private:
  static constexpr std::size_t kMaxWindow = 9;

  void push(JunctionCode held);
  JunctionCode mode() const;

  std::size_t window_;
  std::array<JunctionCode, kMaxWindow> held_{};  // oldest first
  std::size_t size_ = 0;
  JunctionCode smoothed_ = JunctionCode::unrecognised;
};

}  // namespace lineservo::features
