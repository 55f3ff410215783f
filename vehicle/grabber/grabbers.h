#pragma once

#include <memory>
#include <string>

#include "vehicle/grabber/frame_source.h"

namespace lineservo::vehicle {

/// What a camera is asked for; SourceFormat says what it gives. Files keep their size.
struct GrabberOptions {
  int width_px = 640, height_px = 480;
  double rate_hz = 30.0;  ///< of images, too, and of videos that do not say theirs
};

/// Opens a folder, a numbered sequence, a video file, a V4L2 device, a URL or a GStreamer pipeline
/// (source_kind()). Throws GrabberError when it cannot be opened or shows no frame (of a video file: fewer
/// than two); a frame of another size than the first ends it with a GrabberError too.
std::unique_ptr<FrameSource> open_source(const std::string& name, const GrabberOptions& options = {});

}  // namespace lineservo::vehicle
