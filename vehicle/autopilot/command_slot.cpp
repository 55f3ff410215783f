#include "vehicle/autopilot/command_slot.h"

namespace lineservo::vehicle {

bool CommandSlot::offer(const Setpoint& setpoint, Time stamp, Time holds_for, Time now) {
  if (!is_finite(setpoint) || holds_for <= Time(0) || stamp > now) return false;
  if (current_ && stamp < current_->stamp) return false;
  current_ = Entry{setpoint, stamp, stamp + holds_for};
  return true;
}

const Setpoint* CommandSlot::live(Time now) const {
  return current_ && !land_requested() && now <= current_->until ? &current_->setpoint : nullptr;
}

bool CommandSlot::land_requested() const {
  return current_ && std::holds_alternative<LandSetpoint>(current_->setpoint);
}

}  // namespace lineservo::vehicle
