#pragma once

#include <optional>
#include <string>

#include "vehicle/floor/frame.h"

namespace lineservo::apps {

/// The door of perception: frames come in order, each once, in time, and each shows something new.
class FrameGate {
 public:
  /// `oldest`: a frame that comes longer after its exposure is of no use. `patience`: so long without a good
  /// frame before a tick goes on without one.
  FrameGate(vehicle::Time oldest, vehicle::Time patience) : oldest_(oldest), patience_(patience) {}

  /// Whether a frame is to be looked at. Only in flight must each show something new.
  bool accepts(const vehicle::Frame& frame, vehicle::Time now, bool in_flight);
  /// No good frame came for so long that it is time to go on without one; asked again after a tenth of a
  /// second.
  bool is_blind(vehicle::Time now);
  /// What has just begun to be wrong, or what is right again, once.
  std::optional<std::string> take_news();

 private:
  void note(const char* fault, vehicle::Time now);
  const char* fault_of(const vehicle::Frame& frame, vehicle::Time now, bool in_flight) const;

  vehicle::Time oldest_, patience_;
  vehicle::Time last_good_{0}, last_blind_{0}, last_fault_{0};
  std::optional<vehicle::Frame> last_;
  const char* fault_ = nullptr;  ///< the last one, until good frames alone have come for a second
  std::optional<std::string> news_;
};

}  // namespace lineservo::apps
