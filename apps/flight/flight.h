#pragma once

#include <deque>
#include <functional>
#include <utility>

#include "apps/config/flight_request.h"
#include "apps/flight/flight_record.h"
#include "apps/flight/frame_gate.h"
#include "apps/onboard/mission_chain.h"
#include "servo/law/odometry.h"
#include "vehicle/floor/frame_faults.h"
#include "vehicle/floor/layout.h"
#include "vehicle/floor/synthetic_camera.h"
#include "vehicle/quadrotor.h"

namespace lineservo::apps {

/// What a flight shows of itself while it goes on.
struct FlightProgress {
  double time_s = 0.0;
  servo::Phase phase = servo::Phase::take_off;
  int step = 0;
  int steps = 0;
};

/// One control tick of a flight, for those who look on. Valid during the call.
struct FlightTick {
  const TickInput& input;
  const cv::Mat* bgr;  ///< none when the tick went on without a frame
  const features::FrameFeatures& features;
  const servo::Command& command;
  const MissionChain& chain;  ///< what made them
  const TruthSample& truth;   ///< now
};
using TickListener = std::function<void(const FlightTick&)>;

/// One simulated flight: closes the loop vehicle → camera → features → law → command → vehicle in lock-step.
/// The only place that sees all three sides.
class Flight {
 public:
  /// `floor` is what the camera sees; the plan may have been compiled from another layout. Throws
  /// std::invalid_argument.
  Flight(const FlightRequest& request, const vehicle::Layout& floor, const servo::Plan& plan);

  /// Calls `on_tick` at the end of every control tick.
  void listen(TickListener on_tick) { on_tick_ = std::move(on_tick); }
  /// Flies on by a few milliseconds, in which there may be a tick; false when the flight is over.
  bool step();

  /// Flies to the end. `progress` is called about once a simulated second; when it
  /// returns false the flight is broken off.
  FlightRecord run(const std::function<bool(const FlightProgress&)>& progress = {});

 private:
  void advance();
  void sample_truth();
  void expose();
  void control();
  void tick(const vehicle::Frame* frame);
  TickInput observe(const vehicle::Frame* frame) const;
  void send(const servo::Command& command);
  void log(const TickInput& input, const servo::Command& command);
  void watch_autopilot();
  void report(std::string kind, std::string detail);
  bool in_flight() const;
  bool is_over() const;
  bool is_out_of_time() const;
  void finish();

  FlightRequest request_;
  vehicle::Quadrotor quadrotor_;
  vehicle::SyntheticCamera camera_;
  vehicle::FrameFaults frame_faults_;
  FrameGate gate_;
  MissionChain chain_;
  servo::Odometry odometry_;
  std::deque<TruthSample> exposures_;  ///< of the frames under way
  vehicle::Time latency_known_;        ///< what the law takes the camera's latency for
  double time_limit_s_;                ///< that of the settings and the mission's waits, for each target
  vehicle::AutopilotMode mode_ = vehicle::AutopilotMode::idle;
  TickListener on_tick_;
  FlightRecord record_;
};

}  // namespace lineservo::apps
