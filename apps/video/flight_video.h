#pragma once

#include "apps/overlay/flight_scene.h"
#include "apps/video/video_file.h"

namespace lineservo::apps {

/// flight.mp4: what the flight's camera saw, with the overlay, at the camera's frame rate in real time.
class FlightVideo {
 public:
  /// Throws InputError.
  FlightVideo(ResultFolder& folder, const Mission& mission);

  void add(const FlightTick& tick);
  /// Ends the file; publishing is the folder's. Throws InputError.
  void write();
  /// As VideoFile::note().
  const std::string& note() const { return file_.note(); }

 private:
  Overlay overlay_;
  VideoFile file_;
};

/// An earlier flight's video goes when the folder is published without a new one.
void leave_out_video(ResultFolder& folder);

}  // namespace lineservo::apps
