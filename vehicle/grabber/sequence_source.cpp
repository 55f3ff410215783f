#include <fmt/format.h>
#include <visp3/io/vpDiskGrabber.h>

#include <vector>

#include "vehicle/grabber/sequence_pattern.h"
#include "vehicle/grabber/sources.h"
#include "vehicle/grabber/visp_image.h"

namespace lineservo::vehicle {
namespace {

/// vpDiskGrabber over the numbers that are there, up to the first gap.
class SequenceSource : public FrameSource {
 public:
  SequenceSource(const std::string& pattern, double rate_hz)
      : pattern_(pattern), numbers_(SequencePattern(pattern).numbers()), rate_hz_(rate_hz) {
    if (numbers_.empty()) throw GrabberError(pattern + ": there is no such image");
    grabber_.setGenericName(SequencePattern(pattern).for_long());
    grabber_.setStep(1L);
    const cv::Mat first = read(numbers_.front());
    format_ = {first.cols, first.rows, rate_hz};
  }

  SourceFormat format() const override { return format_; }
  std::optional<SourceFrame> next() override {
    if (static_cast<std::size_t>(index_) == numbers_.size()) return std::nullopt;
    const long number = numbers_.front() + static_cast<long>(index_);
    if (numbers_[static_cast<std::size_t>(index_)] != number)
      throw GrabberError(
          fmt::format("{}: number {} is missing, the sequence goes on later", pattern_, number));
    SourceFrame frame = frame_of_file(read(number), index_, rate_hz_);
    ++index_;
    return frame;
  }

 private:
  cv::Mat read(long number) try {
    const QuietStreams quiet;
    vpImage<vpRGBa> image;
    grabber_.acquire(image, number);
    if (image.getSize() == 0) throw GrabberError("");
    return bgr_of(image);
  } catch (const std::exception&) {
    throw GrabberError(fmt::format("{}: number {} is not an image that can be read", pattern_, number));
  }

  std::string pattern_;
  std::vector<long> numbers_;
  double rate_hz_;
  vpDiskGrabber grabber_;
  SourceFormat format_;
  std::int64_t index_ = 0;
};

}  // namespace

std::unique_ptr<FrameSource> open_sequence(const std::string& pattern, const GrabberOptions& options) {
  return std::make_unique<SequenceSource>(pattern, options.rate_hz);
}

}  // namespace lineservo::vehicle
