#pragma once

#include <cstdint>
#include <memory>

#include "vehicle/autopilot/mode.h"
#include "vehicle/autopilot/options.h"
#include "vehicle/body/airframe.h"
#include "vehicle/body/wind.h"
#include "vehicle/body_state.h"
#include "vehicle/estimate.h"
#include "vehicle/sensors/sensor_faults.h"
#include "vehicle/sensors/sensor_parameters.h"
#include "vehicle/setpoint.h"
#include "vehicle/time.h"

namespace lineservo::vehicle {

/// Where the vehicle is put down.
struct StartPlace {
  double x_m = 0.0;
  double y_m = 0.0;
  double heading_rad = 0.0;
};

/// A simulated quadrotor: body, motors, sensors, estimator and autopilot in lock-step, one millisecond at a
/// time. It starts on the floor with stopped motors.
class Quadrotor {
 public:
  /// Throws std::invalid_argument for bad parameters. Without a wind the air is still.
  Quadrotor(const AirframeParameters& airframe, const AutopilotOptions& options,
            const SensorParameters& sensors, std::unique_ptr<Wind> wind, std::uint64_t seed,
            const StartPlace& start, const SensorFaultOptions& faults = {});
  ~Quadrotor();
  Quadrotor(Quadrotor&&) noexcept;
  Quadrotor& operator=(Quadrotor&&) noexcept;

  /// Goes on by one kPhysicsStep.
  void step();

  /// What to do, thought up at `stamp`, good until `stamp + holds_for`. A command that is not finite, older
  /// than the one in force, from the future or (but for landing) run out is refused.
  void command(const Setpoint& setpoint, Time stamp, Time holds_for = kDefaultHold);
  /// The paint was seen in a picture taken at t.
  void paint_sighted(Time t);

  Time now() const;
  AutopilotMode mode() const;
  /// The newest estimate, and the one for a time in the last second (the nearest that there is beyond).
  const Estimate& estimate() const;
  Estimate estimate_at(Time t) const;

  /// For scoring and cameras.
  const BodyState& truth() const;
  /// Hit the floor faster than 1 m/s or turned over (80°). The motors stop for good.
  bool crashed() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lineservo::vehicle
