#pragma once

#include <Eigen/Core>
#include <optional>

#include "servo/law/follow_law.h"

namespace lineservo::servo {

/// Parameters of vtp's published code, for its own track: pixels of its 160×120 frame, metres of its steps.
struct VtpOptions {
  double step_m_per_px = 0.0038;
  double change_m_per_px = 0.002;        ///< on top, of the error's change since the last step
  double change_px = 2.0;                ///< least change that counts
  double arc_px = 27.5;                  ///< radius of the arc on which the target lies
  double period_s = 0.2;                 ///< T_IPS
  double marker_step_m_per_px = 0.0022;  ///< towards the end marker
  double focal_px = 145.0;               ///< of its camera, for the marker's place in its frame
};

/// The speed towards a target straight ahead on the published arc: 0.52 m/s.
inline double published_speed_m_s(const VtpOptions& o) {
  return o.step_m_per_px * o.arc_px / o.period_s;
}

/// `vtp`: pure pursuit of the virtual target point (vtp §3) by position steps, five a second, without control
/// of the heading. A step is flown as the velocity that covers it within the period.
///
/// The target lies on the arc, so its distance is the arc's radius: in units of that radius the published
/// pixels hold for any arc. The steps are scaled so that a target straight ahead is approached at the goal's
/// speed; at the published speed they are the published ones.
class VtpLaw final : public FollowLaw {
 public:
  explicit VtpLaw(const VtpOptions& options) : options_(options) {}

  void reset() override;
  Command follow(const Observation& observation, const FollowGoal& goal) override;
  /// State End-Marker: steps towards the disc in view, each on a new frame. None without a disc.
  std::optional<Command> hover(const Observation& observation, const FollowGoal& goal) override;

 private:
  VelocityCommand step_towards(const Observation& observation, const FollowGoal& goal, double scale) const;
  bool step_is_due(const Observation& observation) const;
  /// Forward and left, in metres of the published track.
  Eigen::Vector2d step_m(const std::optional<features::LevelPoint>& target);

  VtpOptions options_;
  std::optional<Time> stepped_;
  std::optional<Eigen::Vector2d> error_px_;  ///< e of the last step: forward, left
  Eigen::Vector2d step_H_m_ = Eigen::Vector2d::Zero();
};

}  // namespace lineservo::servo
