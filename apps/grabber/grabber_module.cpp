// The part of the program that links ViSP's grabbers and what they pull in (GStreamer, FFmpeg, GDAL): a
// module that is loaded when the first source is opened.

#include <string>

#include "vehicle/grabber/grabbers.h"

using lineservo::vehicle::FrameSource;
using lineservo::vehicle::GrabberOptions;

/// A source, which is the caller's own; none when it cannot be opened, with the complaint.
extern "C" __attribute__((visibility("default"))) FrameSource* lineservo_open_source(
    const std::string* name, const GrabberOptions* options, std::string* complaint) noexcept try {
  return lineservo::vehicle::open_source(*name, *options).release();
} catch (const std::exception& fault) {
  *complaint = fault.what();
  return nullptr;
}
