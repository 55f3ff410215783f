#include "apps/cli/study_progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

namespace lineservo::apps {
namespace {

constexpr std::chrono::seconds kQuietInterval{10};
constexpr std::chrono::milliseconds kTerminalInterval{200};

}  // namespace

StudyProgress::StudyProgress(std::string what, std::string unit)
    : what_(std::move(what)), unit_(std::move(unit)), on_terminal_(::isatty(STDERR_FILENO) == 1) {}

void StudyProgress::show(std::size_t done, std::size_t all) {
  const Clock::time_point now = Clock::now();
  if (now < next_) return;
  next_ = now + (on_terminal_ ? kTerminalInterval : Clock::duration(kQuietInterval));
  const double passed_s = std::chrono::duration<double>(now - begun_).count();
  const double share = static_cast<double>(done) / static_cast<double>(all);
  const std::string to_go = done == 0 ? "" : ", " + clock_text(passed_s * (1.0 - share) / share) + " to go";
  const std::string line = fmt::format("{}{}: {} of {} {}{}{}", on_terminal_ ? "\r" : "", what_, done, all,
                                       unit_, to_go, on_terminal_ ? "\033[K" : "\n");
  std::fputs(line.c_str(), stderr);  // a closed stderr must not end the study
  std::fflush(stderr);
}

void StudyProgress::clear() {
  if (on_terminal_) std::fputs("\r\033[K", stderr);
}

std::string clock_text(double seconds) {
  const long whole = std::lround(std::ceil(seconds));
  if (whole < 3600) return fmt::format("{}:{:02}", whole / 60, whole % 60);
  return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

}  // namespace lineservo::apps
