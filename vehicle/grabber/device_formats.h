#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace lineservo::vehicle {

/// The pixel formats (V4L2_PIX_FMT_*) that a device offers. Throws GrabberError when it is not there, may not
/// be opened, or does not capture.
std::vector<std::uint32_t> device_formats(const std::string& device);

/// How a device is read.
enum class DeviceReader {
  visp_yuyv,  ///< vpV4l2Grabber, which knows raw formats only and sets 25 or 50 frames/s only
  visp_rgb,
  visp_grey,
  capture,  ///< cv::VideoCapture
};

/// MJPEG where the device offers it (it is what fast or large frames need), else 0: whatever it gives.
std::uint32_t capture_format(const std::vector<std::uint32_t>& formats);

/// vpV4l2Grabber where it has a format and the rate, else cv::VideoCapture.
DeviceReader device_reader(const std::vector<std::uint32_t>& formats, double rate_hz);

}  // namespace lineservo::vehicle
