#include <fmt/format.h>
#include <visp3/io/vpVideoReader.h>

#include <cmath>
#include <cstring>
#include <filesystem>

#include "vehicle/grabber/sources.h"
#include "vehicle/grabber/visp_image.h"

namespace lineservo::vehicle {
namespace {

/// vpVideoReader from the first frame to the last. Its open() hands back the second frame, which is not used:
/// the first acquire() gives the first. Past the last frame that can be decoded acquire() repeats it without
/// a word: a frame that equals the one before is asked for again by getFrame(), which tells.
class VideoSource : public FrameSource {
 public:
  VideoSource(const std::string& file, double rate_hz) : file_(file) {
    open();
    const double own_hz = reader_.getFramerate();
    rate_hz_ = std::isfinite(own_hz) && own_hz > 0.0 ? own_hz : rate_hz;
    format_ = {static_cast<int>(image_.getWidth()), static_cast<int>(image_.getHeight()), rate_hz_};
  }

  SourceFormat format() const override { return format_; }
  std::optional<SourceFrame> next() override {
    if (reader_.end()) return std::nullopt;
    acquire();
    SourceFrame frame = frame_of_file(bgr_of(image_), index_, rate_hz_);
    ++index_;
    return frame;
  }

 private:
  void open() try {
    const QuietStreams quiet;
    reader_.setFileName(file_);
    reader_.open(image_);
    if (image_.getSize() == 0) throw GrabberError("");
  } catch (const std::exception&) {
    throw GrabberError(file_ + ": is not a video of at least two frames that can be read");
  }
  void acquire() try {
    const QuietStreams quiet;
    vpImage<vpRGBa> before = image_;
    reader_.acquire(image_);
    const bool repeats = index_ > 0 && before == image_;
    if (repeats && !reader_.getFrame(image_, static_cast<long>(index_))) throw GrabberError("");
  } catch (const std::exception&) {
    throw GrabberError(fmt::format("{}: stops after {} frames: the next one cannot be read", file_, index_));
  }

  std::string file_;
  vpVideoReader reader_;
  vpImage<vpRGBa> image_;
  double rate_hz_ = 0.0;
  SourceFormat format_;
  std::int64_t index_ = 0;
};

}  // namespace

std::unique_ptr<FrameSource> open_video(const std::string& file, const GrabberOptions& options) {
  const std::filesystem::path path = file;
  if (!std::filesystem::is_regular_file(path))
    throw GrabberError(file + ": there is no such file, folder, device, sequence (%04d) or URL");
  if (path.extension().empty() || path.extension() == ".")
    throw GrabberError(file + ": the name of a video must end with its format, as .mp4 or .avi");
  return std::make_unique<VideoSource>(file, options.rate_hz);
}

}  // namespace lineservo::vehicle
