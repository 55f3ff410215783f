#pragma once

#include <optional>

#include "vehicle/setpoint.h"
#include "vehicle/time.h"

namespace lineservo::vehicle {

/// The command in force: the newest by its stamp, until its time is over.
class CommandSlot {
 public:
  /// Refuses, and says so, what is not finite, older than the command in force, from the future, or has run
  /// out by now.
  bool offer(const Setpoint& setpoint, Time stamp, Time holds_for, Time now);

  /// The command, if it is to fly and has not run out.
  const Setpoint* live(Time now) const;
  /// Landing does not run out.
  bool land_requested() const;
  void clear() { current_.reset(); }

 private:
  struct Entry {
    Setpoint setpoint;
    Time stamp;
    Time until;
  };
  std::optional<Entry> current_;
};

}  // namespace lineservo::vehicle
