#pragma once

#include <memory>

#include "vehicle/body/airframe.h"
#include "vehicle/body/wrench.h"
#include "vehicle/body_state.h"
#include "vehicle/time.h"

namespace lineservo::vehicle {

/// The length of a physics step. Fixed: nothing in a flight depends on how it is asked for.
inline constexpr Time kPhysicsStep = std::chrono::milliseconds(1);

/// What the floor did to the body in the last step.
struct GroundContact {
  bool touches = false;
  double impact_speed_m_s = 0.0;  ///< downward, just before the touch
};

/// A box under gravity above a plane floor at z = 0, integrated by Bullet in double precision.
class RigidBody {
 public:
  RigidBody(const AirframeParameters& airframe, const BodyState& start);
  ~RigidBody();
  RigidBody(RigidBody&&) noexcept;
  RigidBody& operator=(RigidBody&&) noexcept;

  /// One kPhysicsStep under gravity and this wrench, taken as the value in the middle of the step.
  void step(const Wrench& wrench);

  const BodyState& state() const;
  /// Where the body will be in the middle of the next step, to first order: where to sample its forces.
  BodyState mid_step_state() const;
  const GroundContact& ground_contact() const;

 private:
  class World;
  std::unique_ptr<World> world_;
};

}  // namespace lineservo::vehicle
