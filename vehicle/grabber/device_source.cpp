#include <fmt/format.h>
#include <visp3/sensor/vpV4l2Grabber.h>

#include "vehicle/grabber/device_formats.h"
#include "vehicle/grabber/sources.h"
#include "vehicle/grabber/visp_image.h"

namespace lineservo::vehicle {
namespace {

/// vpV4l2Grabber at full size (its own default is half of it). The driver's stamps make up for the frames
/// that wait in its buffers.
class DeviceSource : public FrameSource {
 public:
  DeviceSource(const std::string& device, vpV4l2Grabber::vpV4l2PixelFormatType pixels,
               const GrabberOptions& options)
      : device_(device) {
    grabber_.setDevice(device);
    grabber_.setPixelFormat(pixels);
    grabber_.setWidth(static_cast<unsigned>(options.width_px));
    grabber_.setHeight(static_cast<unsigned>(options.height_px));
    grabber_.setScale(1);
    grabber_.setFramerate(options.rate_hz == 50.0 ? vpV4l2Grabber::framerate_50fps
                                                  : vpV4l2Grabber::framerate_25fps);
    open();
    format_ = {static_cast<int>(image_.getWidth()), static_cast<int>(image_.getHeight()), options.rate_hz};
  }

  SourceFormat format() const override { return format_; }
  std::optional<SourceFrame> next() override {
    const timeval stamp = acquire();
    SourceFrame frame;
    frame.index = index_++;
    frame.stamp = std::chrono::seconds(stamp.tv_sec) + std::chrono::microseconds(stamp.tv_usec);
    frame.bgr = bgr_of(image_);
    return frame;
  }

 private:
  void open() try {
    const QuietStreams quiet;
    grabber_.open(image_);
  } catch (const std::exception&) {
    throw GrabberError(device_ + ": does not stream");
  }
  timeval acquire() try {
    const QuietStreams quiet;
    timeval stamp{};
    grabber_.acquire(image_, stamp);
    return stamp;
  } catch (const std::exception&) {
    throw GrabberError(fmt::format("{}: the stream stops after {} frames", device_, index_));
  }

  std::string device_;
  vpV4l2Grabber grabber_;
  vpImage<vpRGBa> image_;
  SourceFormat format_;
  std::int64_t index_ = 0;
};

}  // namespace

std::unique_ptr<FrameSource> open_device(const std::string& device, const GrabberOptions& options) {
  constexpr std::size_t kLongest = 200;  // vpV4l2Grabber copies the name without looking
  if (device.size() > kLongest) throw GrabberError(device + ": too long for the name of a device");
  const std::vector<std::uint32_t> formats = device_formats(device);
  switch (device_reader(formats, options.rate_hz)) {
    case DeviceReader::visp_yuyv:
      return std::make_unique<DeviceSource>(device, vpV4l2Grabber::V4L2_YUYV_FORMAT, options);
    case DeviceReader::visp_rgb:
      return std::make_unique<DeviceSource>(device, vpV4l2Grabber::V4L2_RGB24_FORMAT, options);
    case DeviceReader::visp_grey:
      return std::make_unique<DeviceSource>(device, vpV4l2Grabber::V4L2_GREY_FORMAT, options);
    case DeviceReader::capture:
      break;
  }
  return open_capture_device(device, capture_format(formats), options);
}

}  // namespace lineservo::vehicle
