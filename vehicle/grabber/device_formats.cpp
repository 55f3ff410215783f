#include "vehicle/grabber/device_formats.h"

#include <fcntl.h>
#include <linux/videodev2.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "vehicle/grabber/frame_source.h"

namespace lineservo::vehicle {
namespace {

class OpenDevice {
 public:
  explicit OpenDevice(const std::string& device) : descriptor_(::open(device.c_str(), O_RDWR | O_NONBLOCK)) {
    if (descriptor_ < 0) throw GrabberError(device + ": cannot be opened: " + std::strerror(errno));
  }
  ~OpenDevice() { ::close(descriptor_); }
  OpenDevice(const OpenDevice&) = delete;
  OpenDevice& operator=(const OpenDevice&) = delete;

  template <typename Argument>
  bool ask(unsigned long request, Argument& argument) const {
    return ::ioctl(descriptor_, request, &argument) == 0;
  }

 private:
  int descriptor_;
};

}  // namespace

std::vector<std::uint32_t> device_formats(const std::string& device) {
  const OpenDevice open(device);
  v4l2_capability capability{};
  if (!open.ask(VIDIOC_QUERYCAP, capability) || (capability.capabilities & V4L2_CAP_VIDEO_CAPTURE) == 0)
    throw GrabberError(device + ": is not a V4L2 device that captures video");
  std::vector<std::uint32_t> formats;
  v4l2_fmtdesc format{};
  format.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  for (; open.ask(VIDIOC_ENUM_FMT, format); ++format.index) formats.push_back(format.pixelformat);
  return formats;
}

std::uint32_t capture_format(const std::vector<std::uint32_t>& formats) {
  const bool mjpeg = std::find(formats.begin(), formats.end(), V4L2_PIX_FMT_MJPEG) != formats.end();
  return mjpeg ? V4L2_PIX_FMT_MJPEG : 0;
}

DeviceReader device_reader(const std::vector<std::uint32_t>& formats, double rate_hz) {
  const auto has = [&formats](std::uint32_t format) {
    return std::find(formats.begin(), formats.end(), format) != formats.end();
  };
  if (rate_hz != 25.0 && rate_hz != 50.0) return DeviceReader::capture;
  if (has(V4L2_PIX_FMT_YUYV)) return DeviceReader::visp_yuyv;
  if (has(V4L2_PIX_FMT_RGB24)) return DeviceReader::visp_rgb;
  return has(V4L2_PIX_FMT_GREY) ? DeviceReader::visp_grey : DeviceReader::capture;
}

}  // namespace lineservo::vehicle
