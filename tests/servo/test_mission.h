#pragma once

#include <algorithm>
#include <deque>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "servo/executive/executive.h"
#include "servo/law/controllers.h"
#include "tests/servo/test_floor.h"
#include "tests/servo/test_vehicle.h"

namespace lineservo::servo::testing {

/// The mode of the last five raw codes, ties to the first (codes.md); J1 is held.
class CodeWindow {
 public:
  void filter(features::CodeReading& code) {
    code.held = code.raw == features::JunctionCode::unrecognised ? smoothed_ : code.raw;
    window_.push_back(code.held);
    if (window_.size() > 5) window_.pop_front();
    const auto count = [&](features::JunctionCode c) {
      return std::count(window_.begin(), window_.end(), c);
    };
    smoothed_ = *std::max_element(window_.begin(), window_.end(),
                                  [&](auto a, auto b) { return count(a) < count(b); });
    code.smoothed = smoothed_;
  }

 private:
  std::deque<features::JunctionCode> window_;
  features::JunctionCode smoothed_ = features::JunctionCode::straight;
};

/// A whole flight of the executive over a test floor: what it is given.
struct Mission {
  Mission(TestFloor flown, Plan compiled, const Pose& placed)
      : floor(std::move(flown)), plan(std::move(compiled)), start(placed) {}

  TestFloor floor;  ///< as it is flown, which need not be that of the plan
  Plan plan;
  std::string controller = "ibvs";
  ExecutiveOptions options;
  Pose start;
  Eigen::Vector2d drift_W_m_s = Eigen::Vector2d::Zero();
  int frame_steps = TestVehicle::kStepsAt10Hz;
  int delay_steps = TestVehicle::kStepsIn50Ms;
  double time_limit_s = 300.0;
  /// May spoil what perception says at a time and place.
  std::function<void(double t_s, const Pose& pose, features::FrameFeatures&)> spoil;
  /// May add noise to the velocity estimate.
  std::function<Eigen::Vector2d()> velocity_noise_m_s;
};

/// One control tick, before the command was flown.
struct MissionTick {
  double t_s;
  Phase phase;
  std::size_t step;
  Pose pose;
  Command command;
};

/// What became of it.
struct Logbook {
  std::vector<MissionTick> ticks;
  std::vector<std::string> phases, nodes, looks;  ///< details of the events
  Phase end = Phase::take_off;
  AbortReason reason = AbortReason::none;
  Pose pose;  ///< at the end
};

inline void record_events(Executive& executive, Logbook& log) {
  for (const ExecutiveEvent& event : executive.take_events()) {
    if (event.kind == "phase") log.phases.push_back(event.detail);
    if (event.kind == "look") log.looks.push_back(event.detail);
    if (event.kind == "node") log.nodes.push_back(event.detail);
  }
}

inline features::FrameFeatures frame_of(const Mission& mission, const TestVehicle& vehicle,
                                        CodeWindow& window) {
  features::FrameFeatures frame = mission.floor.view(vehicle.pose_at_capture(mission.delay_steps));
  window.filter(frame.code);
  if (mission.spoil) mission.spoil(seconds(vehicle.now()), vehicle.pose(), frame);
  return frame;
}

/// Flies until the mission is finished or its time is up.
inline Logbook fly(const Mission& mission) {
  const Controller& controller = find_controller(mission.controller);
  Executive executive(mission.plan, controller.make({}), controller.traits, mission.options);
  TestVehicle vehicle(mission.start, mission.drift_W_m_s);
  CodeWindow window;
  Logbook log;
  while (executive.phase() != Phase::finished && seconds(vehicle.now()) < mission.time_limit_s) {
    Observation o = vehicle.observe(frame_of(mission, vehicle, window), mission.delay_steps);
    if (mission.velocity_noise_m_s) o.estimate.v_H_m_s.head<2>() += mission.velocity_noise_m_s();
    const Command command = executive.tick(o, vehicle.on_ground());
    log.ticks.push_back(
        {seconds(vehicle.now()), executive.phase(), executive.step(), vehicle.pose(), command});
    record_events(executive, log);
    vehicle.fly(command, mission.frame_steps);
  }
  log.end = executive.phase();
  log.reason = executive.abort_reason();
  log.pose = vehicle.pose();
  return log;
}

}  // namespace lineservo::servo::testing
