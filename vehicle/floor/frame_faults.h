#pragma once

#include <deque>
#include <optional>

#include "vehicle/fault_window.h"
#include "vehicle/floor/frame.h"

namespace lineservo::vehicle {

/// What can go wrong with the camera, each for the frames exposed at a time of its own.
struct FrameFaultOptions {
  FaultWindow black;
  FaultWindow frozen;  ///< the image of the last frame before, with stamps that go on
  FaultWindow silent;  ///< no frames
  FaultWindow late;    ///< one frame in three comes kLate after it should, behind those that follow it
  FaultWindow twice;   ///< every frame comes again a little later
};

/// Spoils frames on their way from the camera to the computer.
class FrameFaults {
 public:
  static constexpr Time kLate = std::chrono::milliseconds(250);
  static constexpr Time kAgain = std::chrono::milliseconds(20);

  explicit FrameFaults(const FrameFaultOptions& options) : options_(options) {}

  /// A frame as the camera delivers it now.
  void take(Frame frame, Time now);
  /// The next frame that has come to the computer by now, or none.
  std::optional<Frame> deliver(Time now);

 private:
  struct Underway {
    Frame frame;
    Time arrival;
  };
  void spoil_image(Frame& frame);

  FrameFaultOptions options_;
  std::deque<Underway> queue_;
  cv::Mat last_;  ///< kept where frames are going to freeze
};

}  // namespace lineservo::vehicle
