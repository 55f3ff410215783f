#include <fmt/format.h>

#include <opencv2/videoio.hpp>

#include "vehicle/grabber/quiet_stderr.h"
#include "vehicle/grabber/sources.h"

namespace lineservo::vehicle {
namespace {

/// What ViSP's grabbers do not read: URLs, pipelines, cameras that give only MJPEG.
class CaptureSource : public FrameSource {
 public:
  /// `capture` is open. Throws GrabberError when it shows no frame.
  CaptureSource(std::unique_ptr<cv::VideoCapture> capture, std::string name)
      : capture_(std::move(capture)), name_(std::move(name)) {
    if (!read(first_)) throw GrabberError(name_ + ": shows no frame");
    const double rate_hz = capture_->get(cv::CAP_PROP_FPS);
    format_ = {first_.cols, first_.rows, rate_hz > 0.0 ? rate_hz : 0.0};
    first_stamp_ = monotonic_now();
  }

  SourceFormat format() const override { return format_; }
  std::optional<SourceFrame> next() override {
    SourceFrame frame;
    frame.index = index_++;
    if (!first_.empty()) {
      frame.bgr = std::move(first_);
      frame.stamp = first_stamp_;
      return frame;
    }
    if (!read(frame.bgr))
      throw GrabberError(fmt::format("{}: the stream stops after {} frames", name_, frame.index));
    frame.stamp = monotonic_now();
    frame.bgr = frame.bgr.clone();
    return frame;
  }

 private:
  bool read(cv::Mat& image) {
    const QuietStderr quiet;
    return capture_->read(image) && !image.empty();
  }

  std::unique_ptr<cv::VideoCapture> capture_;
  std::string name_;
  cv::Mat first_;
  Time first_stamp_{0};
  SourceFormat format_;
  std::int64_t index_ = 0;
};

std::unique_ptr<FrameSource> opened(const std::string& name, int backend, const std::vector<int>& asked) {
  auto capture = std::make_unique<cv::VideoCapture>();
  bool is_open = false;
  try {
    const QuietStderr quiet;
    is_open = capture->open(name, backend, asked);
  } catch (const cv::Exception&) {
  }
  if (!is_open) throw GrabberError(name + ": cannot be opened");
  return std::make_unique<CaptureSource>(std::move(capture), name);
}

}  // namespace

std::unique_ptr<FrameSource> open_stream(const std::string& url) {
  constexpr int kTimeout_ms = 5000;
  return opened(url, cv::CAP_FFMPEG,
                {cv::CAP_PROP_OPEN_TIMEOUT_MSEC, kTimeout_ms, cv::CAP_PROP_READ_TIMEOUT_MSEC, kTimeout_ms});
}

std::unique_ptr<FrameSource> open_pipeline(const std::string& pipeline) {
  return opened(pipeline, cv::CAP_GSTREAMER, {});
}

// V4L2 and OpenCV number formats alike: four characters, the first lowest.
std::unique_ptr<FrameSource> open_capture_device(const std::string& device, std::uint32_t format,
                                                 const GrabberOptions& options) {
  std::vector<int> asked = {cv::CAP_PROP_FRAME_WIDTH, options.width_px, cv::CAP_PROP_FRAME_HEIGHT,
                            options.height_px,        cv::CAP_PROP_FPS, static_cast<int>(options.rate_hz)};
  if (format != 0) asked.insert(asked.begin(), {cv::CAP_PROP_FOURCC, static_cast<int>(format)});
  return opened(device, cv::CAP_V4L2, asked);
}

}  // namespace lineservo::vehicle
