#pragma once

#include <algorithm>
#include <variant>
#include <vector>

#include "servo/law/observation.h"
#include "tests/servo/test_pose.h"

namespace lineservo::servo::testing {

/// A level vehicle that does at once what it is told, plus a drift that its odometry does not know of. Time
/// runs in steps of 1/120 s, so that 10 and 30 frames a second and a delay of 50 ms are whole steps.
class TestVehicle {
 public:
  static constexpr Time kStep{8'333'333};
  static constexpr int kStepsAt30Hz = 4;
  static constexpr int kStepsAt10Hz = 12;
  static constexpr int kStepsIn50Ms = 6;
  static constexpr double kOdometryYaw_rad = 0.7;  ///< heading at which the gyro began to count: any

  explicit TestVehicle(const Pose& start, const Eigen::Vector2d& drift_W_m_s = Eigen::Vector2d::Zero())
      : drift_W_m_s_(drift_W_m_s) {
    history_.push_back({Time{0}, start, {Eigen::Vector2d(3.0, -2.0), start.heading_rad - kOdometryYaw_rad}});
  }

  const Pose& pose() const { return history_.back().pose; }
  bool on_ground() const { return pose().height_m <= 0.0; }
  Time now() const { return history_.back().stamp; }

  /// Flies a command for some steps. An attitude command is not for this vehicle: it stays.
  void fly(const Command& command, int steps) {
    for (int k = 0; k < steps; ++k) step(velocity_of(command));
  }

  /// What the vehicle was like when the frame of a delayed camera was taken.
  const Pose& pose_at_capture(int delay_steps) const { return captured(delay_steps).pose; }

  /// The estimates that go with features of the frame taken `delay_steps` ago.
  Observation observe(features::FrameFeatures features, int delay_steps) const {
    const Moment& then = captured(delay_steps);
    Observation o;
    o.now = now();
    o.captured = then.stamp;
    o.features = std::move(features);
    o.estimate.odometry_now = history_.back().odometry;
    o.estimate.odometry_at_capture = then.odometry;
    o.estimate.height_m = pose().height_m;
    o.estimate.capture_height_m = then.pose.height_m;
    o.estimate.v_H_m_s = {velocity_.forward_m_s, velocity_.left_m_s, velocity_.up_m_s};
    return o;
  }

 private:
  struct Moment {
    Time stamp;
    Pose pose;
    Motion odometry;
  };

  static VelocityCommand velocity_of(const Command& command) {
    if (std::holds_alternative<LandCommand>(command)) return {0.0, 0.0, -0.3, 0.0};
    const auto* velocity = std::get_if<VelocityCommand>(&command);
    return velocity ? *velocity : VelocityCommand{};
  }

  const Moment& captured(int delay_steps) const {
    const auto last = static_cast<int>(history_.size()) - 1;
    return history_[static_cast<std::size_t>(std::max(0, last - delay_steps))];
  }

  void step(const VelocityCommand& velocity) {
    const double dt_s = seconds(kStep);
    const Moment& last = history_.back();
    Pose pose = moved(last.pose, velocity, dt_s);
    pose.p_W += drift_W_m_s_ * dt_s;
    pose.height_m = std::max(0.0, pose.height_m);
    const Pose reckoned = moved({last.odometry.translation_m, last.odometry.yaw_rad}, velocity, dt_s);
    history_.push_back({last.stamp + kStep, pose, {reckoned.p_W, reckoned.heading_rad}});
    velocity_ = velocity;
  }

  Eigen::Vector2d drift_W_m_s_;
  VelocityCommand velocity_;
  std::vector<Moment> history_;
};

}  // namespace lineservo::servo::testing
