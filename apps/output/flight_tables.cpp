#include "apps/output/flight_tables.h"

#include <fmt/format.h>

#include <cstring>
#include <limits>

#include "apps/output/sha256.h"

namespace lineservo::apps {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

CommandRow row(const servo::VelocityCommand& c) {
  return {c.forward_m_s, c.left_m_s, c.up_m_s, c.yaw_rate_rad_s, kNaN, kNaN};
}
CommandRow row(const servo::AttitudeCommand& c) {
  return {kNaN, kNaN, kNaN, c.yaw_rate_rad_s, c.roll_rad, c.pitch_rad};
}
CommandRow row(const servo::LandCommand&) {
  return {};
}

std::string quoted(const std::string& text) {
  std::string doubled;
  for (const char c : text) doubled.append(c == '"' ? 2 : 1, c);
  return fmt::format("\"{}\"", doubled);
}

void append(std::string& bytes, double value) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  bytes.append(raw, sizeof raw);
}

}  // namespace

CommandRow command_row(const servo::Command& command) {
  return std::visit([](const auto& of_its_kind) { return row(of_its_kind); }, command);
}

std::string flight_csv(const FlightRecord& record) {
  std::string csv =
      "t_s,captured_s,phase,step,x_m,y_m,z_m,roll_rad,pitch_rad,heading_rad,vx_W_m_s,vy_W_m_s,vz_W_m_s,"
      "height_estimate_m,forward_estimate_m_s,left_estimate_m_s,line_rho,line_theta_rad,junction_x,junction_"
      "y,"
      "code_raw,code_held,code_smoothed,line_ends,command_forward_m_s,command_left_m_s,command_up_m_s,"
      "command_yaw_rate_rad_s,command_roll_rad,command_pitch_rad\n";
  for (const TickRecord& tick : record.ticks) {
    const TruthSample& s = tick.now;
    const CommandRow c = command_row(tick.command);
    csv += fmt::format("{:.4f},{:.4f},{},{},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},",
                       vehicle::seconds(tick.t), vehicle::seconds(tick.captured), static_cast<int>(s.phase),
                       s.step, s.p_WB.x(), s.p_WB.y(), s.p_WB.z(), s.roll_rad, s.pitch_rad, s.heading_rad,
                       s.v_W.x(), s.v_W.y(), s.v_W.z());
    csv += fmt::format("{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},", tick.height_m, tick.v_H_m_s.x(),
                       tick.v_H_m_s.y(), tick.line_rho.value_or(kNaN), tick.line_theta_rad.value_or(kNaN),
                       tick.junction ? tick.junction->x : kNaN, tick.junction ? tick.junction->y : kNaN);
    csv += fmt::format("{},{},{},{},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f}\n",
                       static_cast<int>(tick.code.raw), static_cast<int>(tick.code.held),
                       static_cast<int>(tick.code.smoothed), tick.code.line_ends_ahead ? 1 : 0, c.forward,
                       c.left, c.up, c.yaw_rate, c.roll, c.pitch);
  }
  return csv;
}

std::string events_csv(const FlightRecord& record) {
  std::string csv = "t_s,kind,detail\n";
  for (const EventRecord& event : record.events) {
    csv += fmt::format("{:.4f},{},{}\n", vehicle::seconds(event.t), event.kind, quoted(event.detail));
  }
  return csv;
}

std::string trajectory_sha256(const FlightRecord& record) {
  std::string bytes;
  bytes.reserve(record.truth.size() * 13 * sizeof(double));
  for (const TruthSample& s : record.truth) {
    append(bytes, vehicle::seconds(s.t));
    for (const Eigen::Vector3d& v : {s.p_WB, s.v_W, s.w_B}) {
      for (int i = 0; i < 3; ++i) append(bytes, v[i]);
    }
    for (const double angle : {s.roll_rad, s.pitch_rad, s.heading_rad}) append(bytes, angle);
  }
  return sha256_hex(bytes);
}

}  // namespace lineservo::apps
