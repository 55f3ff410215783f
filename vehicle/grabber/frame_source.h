#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <stdexcept>
#include <utility>

#include "vehicle/time.h"

namespace lineservo::vehicle {

/// What a source gives: as it is, not as it was asked for.
struct SourceFormat {
  int width_px = 0, height_px = 0;
  double rate_hz = 0.0;  ///< 0: the source does not say
};

/// One frame of a source.
struct SourceFrame {
  std::int64_t index = 0;  ///< from 0
  /// Of files the index by the rate. Of live sources on the monotonic clock: the exposure where the driver
  /// tells it, else the arrival.
  Time stamp{0};
  cv::Mat bgr;  ///< CV_8UC3, the caller's own
};

/// A frame of a file: its stamp is its index by the rate.
inline SourceFrame frame_of_file(cv::Mat bgr, std::int64_t index, double rate_hz) {
  return {index, from_seconds(static_cast<double>(index) / rate_hz), std::move(bgr)};
}

/// A source that is not there, cannot be read, or breaks off: one line that says what and where. The frames
/// before it are good.
class GrabberError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Frames one after the other, from files or a camera.
class FrameSource {
 public:
  FrameSource() = default;
  virtual ~FrameSource() = default;
  FrameSource(const FrameSource&) = delete;
  FrameSource& operator=(const FrameSource&) = delete;

  virtual SourceFormat format() const = 0;
  /// Waits for the next frame; none at the end of files. Throws GrabberError.
  virtual std::optional<SourceFrame> next() = 0;
};

}  // namespace lineservo::vehicle
