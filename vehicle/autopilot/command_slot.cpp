#include "vehicle/autopilot/command_slot.h"

#include <algorithm>

namespace lineservo::vehicle {
namespace {

bool is_landing(const Setpoint& setpoint) {
  return std::holds_alternative<LandSetpoint>(setpoint);
}

// A hold of any length: the sum may not go beyond what Time holds.
Time end_of(Time stamp, Time holds_for) {
  return stamp + std::min(holds_for, Time::max() - std::max(stamp, Time(0)));
}

}  // namespace

bool CommandSlot::offer(const Setpoint& setpoint, Time stamp, Time holds_for, Time now) {
  if (!is_finite(setpoint) || holds_for <= Time(0) || stamp > now) return false;
  if (current_ && stamp < current_->stamp) return false;
  const Time until = end_of(stamp, holds_for);
  if (until < now && !is_landing(setpoint)) return false;
  current_ = Entry{setpoint, stamp, until};
  return true;
}

const Setpoint* CommandSlot::live(Time now) const {
  return current_ && !land_requested() && now <= current_->until ? &current_->setpoint : nullptr;
}

bool CommandSlot::land_requested() const {
  return current_ && is_landing(current_->setpoint);
}

}  // namespace lineservo::vehicle
