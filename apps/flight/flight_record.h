#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "features/frame_features.h"
#include "servo/executive/phase.h"
#include "servo/law/motion.h"
#include "servo/task/command.h"
#include "vehicle/time.h"

namespace lineservo::apps {

/// The true state, sampled every kTruthPeriod: what scoring and the trajectory's hash rest on.
struct TruthSample {
  vehicle::Time t{0};
  Eigen::Vector3d p_WB = Eigen::Vector3d::Zero();
  double roll_rad = 0.0, pitch_rad = 0.0, heading_rad = 0.0;
  Eigen::Vector3d v_W = Eigen::Vector3d::Zero();
  Eigen::Vector3d w_B = Eigen::Vector3d::Zero();
  servo::Phase phase = servo::Phase::take_off;
  int step = 0;
};

inline constexpr vehicle::Time kTruthPeriod = std::chrono::milliseconds(10);

/// One control tick, as it goes into flight.csv.
struct TickRecord {
  vehicle::Time t{0};
  vehicle::Time captured{0};
  TruthSample at_capture;  ///< truth at the exposure, for scoring the codes
  TruthSample now;
  features::CodeReading code;
  std::optional<double> line_rho, line_theta_rad;
  std::optional<features::LevelPoint> junction;
  double height_m = 0.0;
  Eigen::Vector3d v_H_m_s = Eigen::Vector3d::Zero();
  servo::Motion odometry;  ///< dead reckoning since the flight began
  servo::Command command;
  bool has_frame = true;  ///< otherwise the tick went on without one
};

/// One row of events.csv.
struct EventRecord {
  vehicle::Time t{0};
  std::string kind;
  std::string detail;
};

/// Processor time spent by the thread that flies, and in how many calls.
struct StageTiming {
  double total_s = 0.0;
  long calls = 0;
  double mean_ms() const { return calls == 0 ? 0.0 : 1000.0 * total_s / static_cast<double>(calls); }
};

/// What a flight took: wall time, and processor time of its stages.
struct FlightTiming {
  double wall_s = 0.0;
  StageTiming render, perception, control, physics;
};

/// Everything that a flight leaves behind.
struct FlightRecord {
  std::vector<TruthSample> truth;
  std::vector<TickRecord> ticks;
  std::vector<EventRecord> events;
  servo::AbortReason abort_reason = servo::AbortReason::none;
  servo::Phase last_phase = servo::Phase::take_off;
  int steps_done = 0;  ///< nodes of the plan that were recognised as expected
  bool crashed = false;
  bool landed = false;
  bool out_of_time = false;
  bool interrupted = false;
  FlightTiming timing;
};

}  // namespace lineservo::apps
