// The part of the program that links OpenCV's video writers and what they pull in (FFmpeg, GStreamer): a
// module that is loaded when the first video is begun.

#include <opencv2/videoio.hpp>

#include "apps/video/video_sink.h"
#include "vehicle/grabber/quiet_stderr.h"

namespace {

using lineservo::apps::VideoSink;
using lineservo::apps::VideoSpec;
using lineservo::vehicle::QuietStderr;

/// OpenCV writes MJPEG by itself, everything else by FFmpeg.
int writer_of(const VideoSpec& spec) {
  return spec.codec.fourcc == "MJPG" ? cv::CAP_OPENCV_MJPEG : cv::CAP_FFMPEG;
}

class OpenCvSink final : public VideoSink {
 public:
  explicit OpenCvSink(const VideoSpec& spec) : spec_(spec) {
    const QuietStderr quiet;
    const std::string& c = spec.codec.fourcc;
    writer_.open(spec.path, writer_of(spec), cv::VideoWriter::fourcc(c.at(0), c.at(1), c.at(2), c.at(3)),
                 spec.rate_hz, spec.size);
  }

  bool is_open() const { return writer_.isOpened(); }

  void write(const cv::Mat& bgr) override try {
    const QuietStderr quiet;
    ++frames_;
    writer_.write(bgr);
  } catch (const cv::Exception&) {
    failed_ = true;
  }

  bool finish() override try {
    const QuietStderr quiet;
    writer_.release();
    cv::VideoCapture reader(spec_.path, cv::CAP_FFMPEG);
    if (!reader.isOpened()) reader.open(spec_.path);
    return !failed_ && reader.isOpened() &&
           reader.get(cv::CAP_PROP_FRAME_COUNT) >= static_cast<double>(frames_) && shows(reader, frames_ - 1);
  } catch (const cv::Exception&) {
    return false;
  }

 private:
  static bool shows(cv::VideoCapture& reader, long frame) {
    cv::Mat bgr;
    reader.set(cv::CAP_PROP_POS_FRAMES, static_cast<double>(frame));
    return reader.read(bgr) && !bgr.empty();
  }

  VideoSpec spec_;
  cv::VideoWriter writer_;
  long frames_ = 0;
  bool failed_ = false;
};

}  // namespace

/// A video file, which is the caller's own; none when it cannot be begun so.
extern "C" __attribute__((visibility("default"))) VideoSink* lineservo_open_video(
    const VideoSpec* spec) noexcept try {
  auto sink = std::make_unique<OpenCvSink>(*spec);
  return sink->is_open() ? sink.release() : nullptr;
} catch (...) {
  return nullptr;
}
