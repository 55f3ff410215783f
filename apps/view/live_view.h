#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "apps/onboard/tick_input.h"
#include "apps/overlay/overlay.h"
#include "apps/view/view.h"

namespace lineservo::apps {

/// The windows of --view: the overlay, and plots of features and velocities.
class LiveView {
 public:
  LiveView(Overlay overlay, std::unique_ptr<ViewWindow> window, std::function<bool()> goes_on);

  /// Returns when the next tick may come.
  void show(const OverlayScene& scene, const TickInput& input);
  /// As View::wants_end(): to be taken as Ctrl-C.
  bool wants_end() const { return view_.wants_end(); }
  /// As View::take_news().
  std::optional<std::string> take_news() { return view_.take_news(); }

 private:
  Overlay overlay_;
  View view_;
};

/// What is plotted of a tick.
PlotSample sample_of(const OverlayScene& scene, const TickInput& input);

/// Opens the windows; none where there is no display: `complaint` then says why.
std::unique_ptr<LiveView> open_live_view(Overlay overlay, const std::string& title,
                                         std::function<bool()> goes_on, std::string& complaint);

}  // namespace lineservo::apps
