#include "vehicle/floor/frame_faults.h"

#include <algorithm>
#include <utility>

namespace lineservo::vehicle {

void FrameFaults::take(Frame frame, Time now) {
  const Time exposed = frame.stamp;
  if (options_.silent.holds(exposed)) return;
  spoil_image(frame);
  const bool is_late = options_.late.holds(exposed) && frame.index % 3 == 0;
  if (options_.twice.holds(exposed)) queue_.push_back({frame, now + kAgain});
  queue_.push_back({std::move(frame), is_late ? now + kLate : now});
}

void FrameFaults::spoil_image(Frame& frame) {
  const bool freezes = options_.frozen.holds(frame.stamp) && !last_.empty();
  if (freezes) frame.bgr = last_;
  if (options_.frozen.is_set()) last_ = frame.bgr;
  // A new image: zeros() assigned would be written into the pixels that others hold.
  if (options_.black.holds(frame.stamp))
    frame.bgr = cv::Mat(frame.bgr.size(), frame.bgr.type(), cv::Scalar());
}

std::optional<Frame> FrameFaults::deliver(Time now) {
  const auto first = std::min_element(queue_.begin(), queue_.end(), [](const Underway& a, const Underway& b) {
    return a.arrival < b.arrival;
  });
  if (first == queue_.end() || first->arrival > now) return std::nullopt;
  std::optional<Frame> frame(std::move(first->frame));
  queue_.erase(first);
  return frame;
}

}  // namespace lineservo::vehicle
