#include "vehicle/floor/frame_link.h"

#include <algorithm>
#include <stdexcept>

#include "vehicle/random.h"

namespace lineservo::vehicle {
namespace {

constexpr Time kLeastApart = std::chrono::milliseconds(1);

// Streams of the seed: one for each frame.
constexpr std::uint64_t kLossStream = 0x6c6f7373ULL << 32, kJitterStream = 0x6a697474ULL << 32;

Random of_frame(std::uint64_t seed, std::uint64_t stream, std::int64_t frame) {
  return Random(seed, stream + static_cast<std::uint64_t>(frame));
}

bool within(double value, double low, double high) {
  return value >= low && value <= high;
}

}  // namespace

FrameLink::FrameLink(const FrameLinkOptions& options, std::uint64_t seed) : options_(options), seed_(seed) {
  if (!within(options.latency_s, 0.0, 1.0))
    throw std::invalid_argument("camera: the latency must be 0 to 1 s");
  if (!within(options.jitter_s, 0.0, 0.5))
    throw std::invalid_argument("camera: the latency's jitter must be 0 to 0.5 s");
  if (!within(options.drop_share, 0.0, 0.9))
    throw std::invalid_argument("camera: the share of dropped frames must be 0 to 0.9");
}

bool FrameLink::loses(std::int64_t frame) const {
  return options_.drop_share > 0.0 && of_frame(seed_, kLossStream, frame).uniform() < options_.drop_share;
}

Time FrameLink::arrival(std::int64_t frame, Time stamp, Time read_out) {
  double latency_s = options_.latency_s;
  if (options_.jitter_s > 0.0)
    latency_s += of_frame(seed_, kJitterStream, frame).uniform(-options_.jitter_s, options_.jitter_s);
  Time arrival = std::max(stamp + from_seconds(latency_s), read_out);
  if (last_ != Time::min()) arrival = std::max(arrival, last_ + kLeastApart);
  return last_ = arrival;
}

}  // namespace lineservo::vehicle
