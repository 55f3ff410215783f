#pragma once

#include <string>

namespace lineservo::vehicle {

/// What the name of a source stands for.
enum class SourceKind {
  folder,    ///< of images, in the order of their names
  sequence,  ///< numbered images: a path with %d or %04d
  device,    ///< V4L2: /dev/video0, or its number alone
  stream,    ///< a URL (rtsp://…)
  pipeline,  ///< GStreamer: elements joined by " ! ", the last an appsink
  video,     ///< any other name is a file
};

/// By the text, and by what is in the file system.
SourceKind source_kind(const std::string& name);

/// The device of a number, "/dev/video0" for "0"; other names stay.
std::string device_path(const std::string& name);

}  // namespace lineservo::vehicle
