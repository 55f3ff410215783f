#include "apps/output/flight_tables.h"

#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <map>
#include <sstream>

#include "apps/output/sha256.h"

namespace lineservo::apps {
namespace {

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts;
  std::stringstream stream(text);
  for (std::string part; std::getline(stream, part, at);) parts.push_back(part);
  return parts;
}

TickRecord some_tick() {
  TickRecord tick;
  tick.t = std::chrono::milliseconds(1250);
  tick.captured = std::chrono::milliseconds(1200);
  tick.now.p_WB = {1.5, -2.25, 0.5};
  tick.now.v_W = {0.1, 0.2, -0.3};
  tick.now.roll_rad = 0.01;
  tick.now.pitch_rad = -0.02;
  tick.now.heading_rad = 1.57;
  tick.now.phase = servo::Phase::follow;
  tick.now.step = 2;
  tick.at_capture.p_WB = {9.0, 9.0, 9.0};
  tick.code = {features::JunctionCode::cross, features::JunctionCode::tee_left,
               features::JunctionCode::straight, true};
  tick.line_rho = 0.125;
  tick.line_theta_rad = -0.25;
  tick.junction = features::LevelPoint{0.5, -0.75};
  tick.height_m = 0.51;
  tick.v_H_m_s = {0.11, 0.21, 0.31};
  tick.command = servo::VelocityCommand{0.1, -0.05, 0.02, 0.3};
  return tick;
}

/// The last row of flight.csv, by column.
std::map<std::string, std::string> last_row(const FlightRecord& record) {
  const std::vector<std::string> lines = split(flight_csv(record), '\n');
  const std::vector<std::string> head = split(lines.front(), ','), row = split(lines.back(), ',');
  EXPECT_EQ(head.size(), row.size());
  std::map<std::string, std::string> cells;
  for (std::size_t i = 0; i < std::min(head.size(), row.size()); ++i) {
    EXPECT_TRUE(cells.emplace(head[i], row[i]).second) << "twice: " << head[i];
  }
  return cells;
}

TEST(FlightCsv, BeginsWithTheTimeAndHasOneRowATick) {
  FlightRecord record;
  EXPECT_TRUE(flight_csv(record).starts_with("t_s,"));
  EXPECT_EQ(split(flight_csv(record), '\n').size(), 1u);
  record.ticks = {some_tick(), some_tick(), some_tick()};
  EXPECT_EQ(split(flight_csv(record), '\n').size(), 4u);
  EXPECT_TRUE(flight_csv(record).ends_with("\n"));
}

TEST(FlightCsv, HoldsTheValuesOfTheTickUnderTheirNames) {
  FlightRecord record;
  record.ticks = {some_tick()};
  const auto row = last_row(record);
  const std::map<std::string, double> expected = {{"t_s", 1.25},
                                                  {"captured_s", 1.2},
                                                  {"x_m", 1.5},
                                                  {"y_m", -2.25},
                                                  {"z_m", 0.5},
                                                  {"roll_rad", 0.01},
                                                  {"pitch_rad", -0.02},
                                                  {"heading_rad", 1.57},
                                                  {"vx_W_m_s", 0.1},
                                                  {"vy_W_m_s", 0.2},
                                                  {"vz_W_m_s", -0.3},
                                                  {"height_estimate_m", 0.51},
                                                  {"step", 2},
                                                  {"phase", 2},
                                                  {"forward_estimate_m_s", 0.11},
                                                  {"line_rho", 0.125},
                                                  {"line_theta_rad", -0.25},
                                                  {"left_estimate_m_s", 0.21},
                                                  {"junction_x", 0.5},
                                                  {"junction_y", -0.75},
                                                  {"code_raw", 3},
                                                  {"code_held", 9},
                                                  {"code_smoothed", 2},
                                                  {"line_ends", 1},
                                                  {"command_left_m_s", -0.05},
                                                  {"command_up_m_s", 0.02},
                                                  {"command_yaw_rate_rad_s", 0.3},
                                                  {"command_forward_m_s", 0.1}};
  for (const auto& [name, value] : expected) EXPECT_DOUBLE_EQ(std::stod(row.at(name)), value) << name;
}

TEST(FlightCsv, WhatIsNotThereIsSpelledNan) {
  FlightRecord record;
  TickRecord tick = some_tick();
  tick.line_rho.reset();
  tick.line_theta_rad.reset();
  tick.junction.reset();
  record.ticks = {tick};
  const auto row = last_row(record);
  for (const char* name :
       {"line_rho", "line_theta_rad", "junction_x", "junction_y", "command_roll_rad", "command_pitch_rad"})
    EXPECT_EQ(row.at(name), "nan") << name;
}

TEST(FlightCsv, EveryKindOfCommandFillsItsOwnColumns) {
  FlightRecord record;
  record.ticks = {some_tick()};
  record.ticks[0].command = servo::AttitudeCommand{0.1, -0.2, 0.3, 0.5};
  auto row = last_row(record);
  EXPECT_EQ(std::stod(row.at("command_roll_rad")), 0.1);
  EXPECT_EQ(std::stod(row.at("command_pitch_rad")), -0.2);
  EXPECT_EQ(std::stod(row.at("command_yaw_rate_rad_s")), 0.3);
  EXPECT_EQ(row.at("command_forward_m_s"), "nan");
  record.ticks[0].command = servo::LandCommand{};
  row = last_row(record);
  EXPECT_EQ(row.at("command_yaw_rate_rad_s"), "nan");
}

TEST(FlightCsv, HoldsPlainNumbersOnly) {
  FlightRecord record;
  record.ticks = {some_tick()};
  for (const auto& [name, cell] : last_row(record)) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    EXPECT_TRUE(error == std::errc{} && end == cell.data() + cell.size()) << name << ": " << cell;
  }
}

TEST(EventsCsv, QuotesTheDetail) {
  FlightRecord record;
  record.events = {{std::chrono::milliseconds(500), "phase", "follow"},
                   {std::chrono::milliseconds(1500), "node", "say \"J3\", go on"}};
  EXPECT_EQ(events_csv(record),
            "t_s,kind,detail\n0.5000,phase,\"follow\"\n1.5000,node,\"say \"\"J3\"\", go on\"\n");
  EXPECT_EQ(events_csv({}), "t_s,kind,detail\n");
}

TEST(TrajectorySha256, OfNothingIsThatOfNothing) {
  EXPECT_EQ(trajectory_sha256({}), sha256_hex(""));
}

TEST(TrajectorySha256, ChangesWithTheLastBitOfAnyState) {
  FlightRecord record;
  record.truth.resize(2);
  const std::string before = trajectory_sha256(record);
  TruthSample& s = record.truth[1];
  for (double* value : {&s.p_WB.x(), &s.p_WB.y(), &s.p_WB.z(), &s.v_W.x(), &s.v_W.y(), &s.v_W.z(), &s.w_B.x(),
                        &s.w_B.y(), &s.w_B.z(), &s.roll_rad, &s.pitch_rad, &s.heading_rad}) {
    *value = 1e-300;
    EXPECT_NE(trajectory_sha256(record), before);
    *value = 0.0;
  }
  s.t = std::chrono::nanoseconds(1);
  EXPECT_NE(trajectory_sha256(record), before);
}

TEST(TrajectorySha256, IsOfTheStateAndNotOfTheWallClock) {
  FlightRecord record;
  record.truth.resize(1);
  const std::string before = trajectory_sha256(record);
  record.timing.wall_s = 3.0;
  EXPECT_EQ(trajectory_sha256(record), before);
}

}  // namespace
}  // namespace lineservo::apps
