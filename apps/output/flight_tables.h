#pragma once

#include <limits>
#include <string>

#include "apps/flight/flight_record.h"
#include "apps/scoring/route_truth.h"

namespace lineservo::apps {

/// A command's columns; what a kind of command does not set is not a number.
struct CommandRow {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  double forward = kNone, left = kNone, up = kNone, yaw_rate = kNone, roll = kNone, pitch = kNone;
};
CommandRow command_row(const servo::Command& command);

/// flight.csv: one row a control tick, SI units, t_s first.
std::string flight_csv(const FlightRecord& record);
/// events.csv: time, kind, detail.
std::string events_csv(const FlightRecord& record);
/// SHA-256 of the state log, every bit of every true state.
std::string trajectory_sha256(const FlightRecord& record);

}  // namespace lineservo::apps
