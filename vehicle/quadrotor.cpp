#include "vehicle/quadrotor.h"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "vehicle/attitude.h"
#include "vehicle/autopilot/autopilot.h"
#include "vehicle/body/flight_dynamics.h"
#include "vehicle/estimator/estimate_history.h"
#include "vehicle/estimator/estimator.h"
#include "vehicle/sensors/sensors.h"

namespace lineservo::vehicle {
namespace {

constexpr double kGentleTouch_m_s = 1.0;
constexpr double kTurnedOver_rad = 80.0 * std::numbers::pi / 180.0;

BodyState standing_at(const StartPlace& place, const AirframeParameters& airframe) {
  if (!std::isfinite(place.x_m) || !std::isfinite(place.y_m) || !std::isfinite(place.heading_rad)) {
    throw std::invalid_argument("start place: x_m, y_m and heading_rad must be finite");
  }
  airframe.validate();
  BodyState state;
  state.p_WB << place.x_m, place.y_m, airframe.gear_height_m;
  state.q_WB = quaternion({0.0, 0.0, place.heading_rad});
  return state;
}

bool is_crash(const BodyState& state, const GroundContact& contact) {
  return contact.impact_speed_m_s > kGentleTouch_m_s || tilt_rad(state.q_WB) > kTurnedOver_rad;
}

std::unique_ptr<Wind> or_still_air(std::unique_ptr<Wind> wind) {
  return wind ? std::move(wind) : std::make_unique<ConstantWind>();
}

}  // namespace

class Quadrotor::Impl {
 public:
  Impl(const AirframeParameters& airframe, const AutopilotOptions& options,
       const SensorParameters& parameters, std::unique_ptr<Wind> wind_or_none, std::uint64_t seed,
       const StartPlace& start, const SensorFaultOptions& fault_options)
      : dynamics(airframe.loaded(), standing_at(start, airframe)),
        wind(or_still_air(std::move(wind_or_none))),
        sensors(parameters, seed, dynamics.state()),
        faults(fault_options, seed),
        estimator(parameters, sensors.sample(Time(0), dynamics.state())),
        autopilot(airframe, options) {
    history.add(estimator.estimate());
  }

  void step() {
    if (now % kInertialPeriod == Time(0)) control();
    dynamics.step(rotor_commands_rad_s, wind->velocity_W(now, dynamics.state().p_WB));
    now += kPhysicsStep;
    crashed = crashed || is_crash(dynamics.state(), dynamics.ground_contact());
    if (now % kInertialPeriod == Time(0)) sense();
  }

  void sense() {
    estimator.update(faults.spoilt(sensors.sample(now, dynamics.state())));
    history.add(estimator.estimate());
  }

  void control() {
    rotor_commands_rad_s = autopilot.update(now, estimator.estimate());
    if (crashed) rotor_commands_rad_s.setZero();
  }

  FlightDynamics dynamics;
  std::unique_ptr<Wind> wind;
  Sensors sensors;
  SensorFaults faults;
  Estimator estimator;
  EstimateHistory history;
  Autopilot autopilot;
  PerRotor rotor_commands_rad_s = PerRotor::Zero();
  Time now{0};
  bool crashed = false;
};

Quadrotor::Quadrotor(const AirframeParameters& airframe, const AutopilotOptions& options,
                     const SensorParameters& sensors, std::unique_ptr<Wind> wind, std::uint64_t seed,
                     const StartPlace& start, const SensorFaultOptions& faults)
    : impl_(std::make_unique<Impl>(airframe, options, sensors, std::move(wind), seed, start, faults)) {}
Quadrotor::~Quadrotor() = default;
Quadrotor::Quadrotor(Quadrotor&&) noexcept = default;
Quadrotor& Quadrotor::operator=(Quadrotor&&) noexcept = default;

void Quadrotor::step() {
  impl_->step();
}
void Quadrotor::command(const Setpoint& setpoint, Time stamp, Time holds_for) {
  impl_->autopilot.command(setpoint, stamp, holds_for, impl_->now);
}
void Quadrotor::paint_sighted(Time t) {
  impl_->autopilot.paint_sighted(t, impl_->estimator.estimate());
}
Time Quadrotor::now() const {
  return impl_->now;
}
AutopilotMode Quadrotor::mode() const {
  return impl_->autopilot.mode();
}
const Estimate& Quadrotor::estimate() const {
  return impl_->estimator.estimate();
}
Estimate Quadrotor::estimate_at(Time t) const {
  return impl_->history.at(t);
}
const BodyState& Quadrotor::truth() const {
  return impl_->dynamics.state();
}
bool Quadrotor::crashed() const {
  return impl_->crashed;
}

}  // namespace lineservo::vehicle
