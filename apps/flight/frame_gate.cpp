#include "apps/flight/frame_gate.h"

#include <cstring>
#include <utility>

namespace lineservo::apps {
namespace {

constexpr vehicle::Time kBlindPeriod = std::chrono::milliseconds(100);
constexpr vehicle::Time kOver = std::chrono::seconds(1);
constexpr int kRowStep = 16;  // rows looked at; noise and motion change every one

constexpr const char* kOfTheFuture = "frames bear stamps of the future: those are not used";
constexpr const char* kNone = "no frames come";

bool shows_the_same(const cv::Mat& a, const cv::Mat& b) {
  if (a.size() != b.size() || a.type() != b.type()) return false;
  for (int y = 0; y < a.rows; y += kRowStep) {
    if (std::memcmp(a.ptr(y), b.ptr(y), static_cast<std::size_t>(a.cols) * a.elemSize()) != 0) return false;
  }
  return true;
}

}  // namespace

const char* FrameGate::fault_of(const vehicle::Frame& frame, vehicle::Time now, bool in_flight) const {
  if (frame.stamp > now) return kOfTheFuture;
  if (last_ && frame.stamp <= last_->stamp) return "frames come out of order or twice: those are not used";
  if (now - frame.stamp > oldest_) return "frames come late: those are not used";
  if (in_flight && last_ && shows_the_same(frame.bgr, last_->bgr))
    return "the image does not change: it is not used";
  return nullptr;
}

bool FrameGate::accepts(const vehicle::Frame& frame, vehicle::Time now, bool in_flight) {
  const char* fault = fault_of(frame, now, in_flight);
  note(fault, now);
  const bool is_newer = fault != kOfTheFuture && (!last_ || frame.stamp > last_->stamp);
  if (is_newer) last_ = frame;
  if (!fault) last_good_ = now;
  return !fault;
}

// A fault that comes and goes is one: it is over when good frames alone have come for a while.
void FrameGate::note(const char* fault, vehicle::Time now) {
  if (fault) {
    if (fault != fault_) news_ = fault;
    fault_ = fault;
    last_fault_ = now;
  } else if (fault_ && now - last_fault_ >= kOver) {
    news_ = "frames are good again";
    fault_ = nullptr;
  }
}

bool FrameGate::is_blind(vehicle::Time now) {
  if (now - last_good_ < patience_ || now - last_blind_ < kBlindPeriod) return false;
  note(fault_ ? fault_ : kNone, now);
  last_blind_ = now;
  return true;
}

std::optional<std::string> FrameGate::take_news() {
  return std::exchange(news_, std::nullopt);
}

}  // namespace lineservo::apps
