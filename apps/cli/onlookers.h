#pragma once

#include <memory>
#include <optional>

#include "apps/flight/mission.h"
#include "apps/output/result_folder.h"
#include "apps/recording/recorder.h"
#include "apps/report/film_strip.h"
#include "apps/video/flight_video.h"
#include "apps/view/live_view.h"

namespace lineservo::apps {

/// What is to be kept or shown of a flight beside its results.
struct Looks {
  bool record = false, video = false, view = false;
};

/// Those who look on at a flight and change nothing of it: the report's film strip, a recording, a video,
/// windows.
class Onlookers {
 public:
  /// `folder` holds what is kept, and gets a report; none when nothing is. Where there is no display a line
  /// says so, and there are no windows. Throws InputError when there is no place for what is to be kept.
  Onlookers(const Looks& looks, const Mission& mission, ResultFolder* folder);

  /// For the report.
  const FilmStrip& film() const { return film_; }
  /// None when nobody looks on.
  TickListener listener();
  /// The user has closed the windows, which is to be taken as Ctrl-C.
  bool want_end() const { return view_ && view_->wants_end(); }
  /// Writes what was kept, and leaves out what an earlier flight kept that this one did not; publishing is
  /// the folder's. Throws InputError.
  void write(ResultFolder& folder);

 private:
  void see(const FlightTick& tick);

  bool films_;
  FilmStrip film_;
  std::optional<Recorder> recorder_;
  std::optional<FlightVideo> video_;
  std::unique_ptr<LiveView> view_;
};

}  // namespace lineservo::apps
