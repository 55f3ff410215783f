#pragma once

#include <deque>
#include <functional>

#include "apps/config/flight_request.h"
#include "apps/flight/flight_record.h"
#include "apps/flight/frame_gate.h"
#include "features/perception.h"
#include "servo/executive/executive.h"
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

/// One simulated flight: closes the loop vehicle → camera → features → law → command → vehicle in lock-step.
/// The only place that sees all three sides.
class Flight {
 public:
  /// `floor` is what the camera sees; the plan may have been compiled from another layout. Throws
  /// std::invalid_argument.
  Flight(const FlightRequest& request, const vehicle::Layout& floor, const servo::Plan& plan);

  /// Flies to the end. `progress` is called about once a simulated second; when it
  /// returns false the flight is broken off.
  FlightRecord run(const std::function<bool(const FlightProgress&)>& progress = {});

 private:
  void advance();
  void sample_truth();
  void expose();
  void control();
  void tick(const vehicle::Frame* frame);
  servo::Observation observe(const vehicle::Frame* frame);
  features::FrameFeatures extract(const vehicle::Frame& frame, const vehicle::Estimate& at_capture);
  void send(const servo::Command& command);
  void log(const servo::Observation& observation, const vehicle::Frame* frame, const servo::Command& command);
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
  features::Perception perception_;
  servo::Executive executive_;
  servo::Odometry odometry_;
  std::deque<TruthSample> exposures_;  ///< of the frames under way
  vehicle::Time latency_known_;        ///< what the law takes the camera's latency for
  double time_limit_s_;                ///< that of the settings, for each target
  vehicle::Time last_looked_at_{0};    ///< exposure of the last frame that perception saw
  vehicle::AutopilotMode mode_ = vehicle::AutopilotMode::idle;
  SoftwareFaultOptions software_faults_;
  FlightRecord record_;
};

}  // namespace lineservo::apps
