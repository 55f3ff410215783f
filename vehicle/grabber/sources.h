#pragma once

#include <functional>
#include <memory>
#include <string>

#include "vehicle/grabber/grabbers.h"

namespace lineservo::vehicle {

/// One for each kind of source, for open_source(). All throw GrabberError.
std::unique_ptr<FrameSource> open_folder(const std::string& folder, const GrabberOptions& options);
std::unique_ptr<FrameSource> open_sequence(const std::string& pattern, const GrabberOptions& options);
std::unique_ptr<FrameSource> open_video(const std::string& file, const GrabberOptions& options);
std::unique_ptr<FrameSource> open_device(const std::string& device, const GrabberOptions& options);
std::unique_ptr<FrameSource> open_stream(const std::string& url);
std::unique_ptr<FrameSource> open_pipeline(const std::string& pipeline);
/// cv::VideoCapture on a device; `format` is a V4L2_PIX_FMT, or 0 for the one that is set.
std::unique_ptr<FrameSource> open_capture_device(const std::string& device, std::uint32_t format,
                                                 const GrabberOptions& options);

/// Now, on the monotonic clock, as V4L2 drivers stamp.
Time monotonic_now();

}  // namespace lineservo::vehicle
