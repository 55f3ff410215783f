#include "apps/watch/grabber_feed.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace lineservo::apps {

GrabberFeed::GrabberFeed(std::unique_ptr<vehicle::FrameSource> source,
                         const features::CameraParameters& camera, Estimates estimates, Pace pace)
    : source_(std::move(source)), camera_(camera), estimates_(std::move(estimates)), pace_(pace) {}

std::optional<WatchTick> GrabberFeed::next() {
  std::optional<vehicle::SourceFrame> frame = source_->next();
  if (!frame) return std::nullopt;
  if (!begin_) begin_ = frame->stamp;
  WatchTick tick;
  tick.frame = frame->index;
  tick.bgr = std::move(frame->bgr);
  TickInput& input = tick.input;
  input.exposed = input.captured = input.now = frame->stamp - *begin_;
  if (is_live()) {
    tick.exposed_at = frame->stamp;
    input.now = std::max(input.now, std::chrono::steady_clock::now().time_since_epoch() - *begin_);
  }
  const EstimateAt then = estimates_.at(input.captured), now = is_live() ? estimates_.at(input.now) : then;
  input.roll_rad = then.roll_rad;
  input.pitch_rad = then.pitch_rad;
  input.estimate = {.odometry_now = now.odometry,
                    .odometry_at_capture = then.odometry,
                    .height_m = now.height_m,
                    .capture_height_m = then.height_m,
                    .v_H_m_s = now.v_H_m_s,
                    .height_age_s = 0.0,
                    .velocity_age_s = 0.0};
  return tick;
}

}  // namespace lineservo::apps
