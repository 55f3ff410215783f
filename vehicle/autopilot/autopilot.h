#pragma once

#include "vehicle/autopilot/cascade.h"
#include "vehicle/autopilot/command_slot.h"
#include "vehicle/autopilot/mode.h"
#include "vehicle/autopilot/odometer.h"

namespace lineservo::vehicle {

/// From commands and estimates to rotor speeds: decides on the mode, keeps the limits, runs the cascade.
class Autopilot {
 public:
  /// An estimate older than this is not flown on.
  static constexpr Time kStale = std::chrono::milliseconds(100);

  Autopilot(const AirframeParameters& airframe, const AutopilotOptions& options);

  void command(const Setpoint& setpoint, Time stamp, Time holds_for, Time now);
  void paint_sighted(Time t, const Estimate& estimate) { blind_.paint_sighted(t, estimate); }

  /// To be called every kInertialPeriod.
  PerRotor update(Time now, const Estimate& estimate);

  AutopilotMode mode() const { return mode_; }

 private:
  Situation situation(Time now, const Estimate& estimate) const;
  bool wants_up(const Setpoint& setpoint) const;
  void watch_ground(Time now, const Estimate& estimate);
  bool stands(Time now, const Estimate& estimate) const;
  PerRotor drive(Time now, const Estimate& estimate);
  void enter(AutopilotMode mode, Time now, const Estimate& estimate);
  PerRotor track(const Setpoint& setpoint, const Estimate& estimate);
  PerRotor brake(const Estimate& estimate);
  PerRotor land(const Estimate& estimate);

  AutopilotOptions options_;
  double gear_height_m_;
  double hover_speed2_rad2_s2_;  ///< sum of the squared rotor speeds that carry the weight
  double speed2_rad2_s2_ = 0.0;  ///< the same as driven
  Cascade cascade_;
  CommandSlot commands_;
  BlindOdometer blind_;
  AutopilotMode mode_ = AutopilotMode::idle;
  Time mode_since_{0};
  Time off_ground_at_{0};  ///< when it was last seen to fly or to move up or down
  double hold_height_m_ = 0.0;
};

}  // namespace lineservo::vehicle
