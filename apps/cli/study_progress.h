#pragma once

#include <chrono>
#include <string>

namespace lineservo::apps {

/// How far a long study is and how long it has to go, on stderr: rewritten in place on a terminal, else a
/// line now and then.
class StudyProgress {
 public:
  /// `what` goes before the figures, `unit` behind them: "compare", "flights".
  StudyProgress(std::string what, std::string unit);
  void show(std::size_t done, std::size_t all);
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  std::string what_, unit_;
  bool on_terminal_;
  Clock::time_point begun_ = Clock::now(), next_ = begun_;
};

/// "1:02:03" or "2:03", rounded up to whole seconds.
std::string clock_text(double seconds);

}  // namespace lineservo::apps
