#pragma once

#include <cstdint>

#include "vehicle/time.h"

namespace lineservo::vehicle {

/// What becomes of frames between the camera and the computer.
struct FrameLinkOptions {
  double latency_s = 0.0;   ///< from mid-exposure to delivery, 0 … 1
  double jitter_s = 0.0;    ///< the latency is off by up to this, either way; 0 … 0.5
  double drop_share = 0.0;  ///< of the frames, each by itself; 0 … 0.9
};

/// Decides for each frame whether it gets lost and when it arrives. Both hang on the seed and the frame's
/// index alone. Frames never overtake each other: one that catches up arrives a millisecond after the one
/// before.
class FrameLink {
 public:
  /// Throws std::invalid_argument for options out of bounds.
  FrameLink(const FrameLinkOptions& options, std::uint64_t seed);

  bool loses(std::int64_t frame) const;
  /// To be asked for each frame that is not lost, in order: it arrives its latency after mid-exposure, and
  /// not before it has been read out.
  Time arrival(std::int64_t frame, Time stamp, Time read_out);

 private:
  FrameLinkOptions options_;
  std::uint64_t seed_;
  Time last_{Time::min()};
};

}  // namespace lineservo::vehicle
