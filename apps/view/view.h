#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/view/view_window.h"

namespace lineservo::apps {

/// The time on the wall, and waiting for it.
struct WallClock {
  std::function<double()> now_s;
  std::function<void(double seconds)> wait;

  static WallClock steady();
};

/// How ticks follow on each other: in real time, as they come, or one at a key.
enum class ViewPace { real_time, fast, paused };

/// Shows ticks one after the other, holds them back to their time, and obeys the keys. Knows of nothing but
/// pictures, samples and times, and changes nothing of what it shows.
class View {
 public:
  /// `pace`: to begin with; `goes_on`: false ends every waiting.
  View(std::unique_ptr<ViewWindow> window, ViewPace pace, std::function<bool()> goes_on,
       WallClock clock = WallClock::steady());

  /// Shows a tick and returns when the next one may come. `draw` is called when the picture is wanted.
  void show(double time_s, const std::function<const cv::Mat&()>& draw, const PlotSample& sample);

  /// The user has had enough.
  bool wants_end() const { return wants_end_; }
  /// What happened to the display, once; none when nothing did.
  std::optional<std::string> take_news();

  /// What the keys do, as lines of text.
  static std::vector<std::string> keys();

 private:
  bool is_over() const { return wants_end_ || is_lost_ || !goes_on_(); }
  void obey_keys();
  void obey(ViewKey key);
  void change(ViewPace pace);
  void watch_window();
  void wait_for(double time_s);
  bool holds_back(double time_s);

  std::unique_ptr<ViewWindow> window_;
  ViewPace pace_, running_;  ///< running_: to which a pause returns
  std::function<bool()> goes_on_;
  WallClock clock_;
  bool steps_ = false;  ///< a tick is let through while paused
  bool wants_end_ = false, is_lost_ = false;
  std::optional<std::string> news_;
  std::optional<double> offset_s_;  ///< wall time less the ticks' time, when in time
  double shown_s_ = -1e9;           ///< on the wall
};

}  // namespace lineservo::apps
