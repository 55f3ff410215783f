#include "apps/view/view.h"

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

namespace lineservo::apps {
namespace {

constexpr double kLook_s = 0.01;         // how often keys are looked for
constexpr double kFastPicture_s = 0.04;  // between pictures when ticks come as fast as they go
constexpr double kTooLate_s = 0.5;       // what is later is not made up for

}  // namespace

WallClock WallClock::steady() {
  return {[] {
            return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
          },
          [](double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }};
}

View::View(std::unique_ptr<ViewWindow> window, ViewPace pace, std::function<bool()> goes_on, WallClock clock)
    : window_(std::move(window)),
      pace_(pace),
      running_(pace),
      goes_on_(std::move(goes_on)),
      clock_(std::move(clock)) {}

std::vector<std::string> View::keys() {
  return {"space: pause     n: one step", "f: fast, real time    q: quit"};
}

void View::show(double time_s, const std::function<const cv::Mat&()>& draw, const PlotSample& sample) {
  if (is_over()) return;
  const double now_s = clock_.now_s();
  if (pace_ != ViewPace::fast || now_s - shown_s_ >= kFastPicture_s) {
    shown_s_ = now_s;
    window_->show(draw());
    window_->plot(sample);
  }
  wait_for(time_s);
  watch_window();
}

// Looks for keys at least once a tick.
void View::wait_for(double time_s) {
  steps_ = false;
  obey_keys();
  while (!is_over() && holds_back(time_s)) {
    clock_.wait(kLook_s);
    obey_keys();
    watch_window();
  }
}

bool View::holds_back(double time_s) {
  if (pace_ == ViewPace::paused) return !steps_;
  if (pace_ == ViewPace::fast) return false;
  const double now_s = clock_.now_s();
  if (!offset_s_ || now_s - *offset_s_ - time_s > kTooLate_s) offset_s_ = now_s - time_s;
  return now_s - *offset_s_ < time_s;
}

void View::obey_keys() {
  while (const auto key = window_->key()) obey(*key);
}

void View::obey(ViewKey key) {
  switch (key) {
    case ViewKey::pause:
      return change(pace_ == ViewPace::paused ? running_ : ViewPace::paused);
    case ViewKey::step:
      steps_ = pace_ == ViewPace::paused;
      return change(ViewPace::paused);
    case ViewKey::fast:
      return change(pace_ == ViewPace::fast ? ViewPace::real_time : ViewPace::fast);
    case ViewKey::quit:
      wants_end_ = true;
  }
}

void View::change(ViewPace pace) {
  if (pace != ViewPace::paused) running_ = pace;
  pace_ = pace;
  offset_s_.reset();
}

void View::watch_window() {
  const WindowState state = window_->state();
  wants_end_ |= state == WindowState::closed;
  if (state != WindowState::lost || is_lost_) return;
  is_lost_ = true;
  news_ = "the display is gone; goes on without --view";
}

std::optional<std::string> View::take_news() {
  return std::exchange(news_, std::nullopt);
}

}  // namespace lineservo::apps
