#include "vehicle/body/rigid_body.h"

#include <btBulletDynamicsCommon.h>

#include <algorithm>
#include <new>

#include "vehicle/attitude.h"

namespace lineservo::vehicle {
namespace {

constexpr double kStep_s = seconds(kPhysicsStep);
constexpr double kFriction = 0.8;
// Bullet keeps contact points up to 2 cm apart; closer than this they count as a touch.
constexpr double kTouchDistance_m = 0.002;

btVector3 to_bullet(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}
btQuaternion to_bullet(const Eigen::Quaterniond& q) {
  return {q.x(), q.y(), q.z(), q.w()};
}
Eigen::Vector3d from_bullet(const btVector3& v) {
  return {v.x(), v.y(), v.z()};
}
Eigen::Quaterniond from_bullet(const btQuaternion& q) {
  return {q.w(), q.x(), q.y(), q.z()};
}

/// Bullet uses what its allocator returns without a look: where there is no memory, it must throw.
void let_allocations_throw() {
  static const bool once = [] {
    btAlignedAllocSetCustom([](std::size_t bytes) { return ::operator new(bytes); },
                            [](void* memory) { ::operator delete(memory); });
    return true;
  }();
  static_cast<void>(once);
}

/// The default pools hold thousands of contacts and cost 5 ms at start; one body on one plane needs few.
btDefaultCollisionConstructionInfo small_pools() {
  btDefaultCollisionConstructionInfo info;
  info.m_defaultMaxPersistentManifoldPoolSize = 128;
  info.m_defaultMaxCollisionAlgorithmPoolSize = 128;
  return info;
}

/// The eight corners of the collision box, its underside at the gear's height below the origin.
btConvexHullShape box_on_gear(const AirframeParameters& airframe) {
  const Eigen::Vector3d& half = airframe.collision_half_extents_m;
  const double bottom = -airframe.gear_height_m;
  btConvexHullShape shape;
  for (const double x : {-half.x(), half.x()}) {
    for (const double y : {-half.y(), half.y()}) {
      for (const double z : {bottom, bottom + 2.0 * half.z()}) shape.addPoint({x, y, z}, false);
    }
  }
  shape.recalcLocalAabb();
  shape.setMargin(0.0);
  return shape;
}

btRigidBody::btRigidBodyConstructionInfo body_info(const AirframeParameters& airframe,
                                                   btCollisionShape* shape) {
  btRigidBody::btRigidBodyConstructionInfo info(airframe.mass_kg, nullptr, shape,
                                                to_bullet(airframe.inertia_kg_m2));
  info.m_friction = kFriction;
  return info;
}

btRigidBody::btRigidBodyConstructionInfo floor_info(btCollisionShape* shape) {
  btRigidBody::btRigidBodyConstructionInfo info(0.0, nullptr, shape);
  info.m_friction = kFriction;
  return info;
}

}  // namespace

class RigidBody::World {
 public:
  World(const AirframeParameters& airframe, const BodyState& start);
  ~World();

  void step(const Wrench& wrench);
  const BodyState& state() const { return state_; }
  BodyState mid_step_state() const;
  const GroundContact& contact() const { return contact_; }

 private:
  void apply(const Wrench& wrench);
  void read_state();
  void read_contact(double descent_m_s);
  void undo_half_step(const BodyState& before);
  void write_pose();

  btDefaultCollisionConfiguration configuration_{small_pools()};
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
  btStaticPlaneShape plane_{btVector3(0, 0, 1), 0};
  btConvexHullShape box_;
  btRigidBody floor_{floor_info(&plane_)};
  btRigidBody body_;
  Eigen::Vector3d inertia_kg_m2_;
  BodyState state_;
  Eigen::Vector3d last_change_v_W_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d last_change_w_B_ = Eigen::Vector3d::Zero();
  GroundContact contact_;
};

RigidBody::World::World(const AirframeParameters& airframe, const BodyState& start)
    : box_(box_on_gear(airframe)),
      body_(body_info(airframe, &box_)),
      inertia_kg_m2_(airframe.inertia_kg_m2),
      state_(start) {
  world_.setGravity({0, 0, -kGravity_m_s2});
  world_.setForceUpdateAllAabbs(false);
  // Our one body never sleeps, and its air drag is ours to model.
  body_.setActivationState(DISABLE_DEACTIVATION);
  body_.setDamping(0.0, 0.0);
  state_.q_WB.normalize();
  write_pose();
  body_.setLinearVelocity(to_bullet(state_.v_W));
  body_.setAngularVelocity(to_bullet(state_.q_WB * state_.w_B));
  world_.addRigidBody(&floor_);
  world_.addRigidBody(&body_);
}

RigidBody::World::~World() {
  world_.removeRigidBody(&body_);
  world_.removeRigidBody(&floor_);
}

// The velocities are carried on by half of their last change, or drag would be of first order only.
BodyState RigidBody::World::mid_step_state() const {
  BodyState middle = state_;
  middle.p_WB += 0.5 * kStep_s * state_.v_W;
  middle.q_WB = state_.q_WB * rotation(0.5 * kStep_s * state_.w_B);
  middle.v_W += 0.5 * last_change_v_W_;
  middle.w_B += 0.5 * last_change_w_B_;
  return middle;
}

void RigidBody::World::step(const Wrench& wrench) {
  const BodyState before = state_;
  apply(wrench);
  world_.stepSimulation(kStep_s, 0);
  read_state();
  read_contact(-before.v_W.z());
  if (!contact_.touches) undo_half_step(before);
  last_change_v_W_ = state_.v_W - before.v_W;
  last_change_w_B_ = state_.w_B - before.w_B;
}

// Bullet turns a moment into angular acceleration with the inertia at the attitude of the step's start,
// ẇ = R₀ I⁻¹ R₀ᵀ τ. So that it comes to R I⁻¹ τ_B with the attitude R of the middle: τ = R₀ I R₀ᵀ R I⁻¹ τ_B.
void RigidBody::World::apply(const Wrench& wrench) {
  const Eigen::Quaterniond q_start = state_.q_WB, q_middle = mid_step_state().q_WB;
  const Eigen::Vector3d w_dot_W = q_middle * wrench.torque_B_Nm.cwiseQuotient(inertia_kg_m2_);
  const Eigen::Vector3d torque_W = q_start * inertia_kg_m2_.cwiseProduct(q_start.conjugate() * w_dot_W);
  body_.applyCentralForce(to_bullet(q_middle * wrench.force_B_N));
  body_.applyTorque(to_bullet(torque_W));
}

void RigidBody::World::read_state() {
  state_.p_WB = from_bullet(body_.getWorldTransform().getOrigin());
  state_.q_WB = from_bullet(body_.getOrientation()).normalized();
  state_.v_W = from_bullet(body_.getLinearVelocity());
  state_.w_B = state_.q_WB.conjugate() * from_bullet(body_.getAngularVelocity());
}

void RigidBody::World::read_contact(double descent_m_s) {
  contact_ = {};
  for (int i = 0; i < dispatcher_.getNumManifolds(); ++i) {
    const btPersistentManifold* manifold = dispatcher_.getManifoldByIndexInternal(i);
    for (int k = 0; k < manifold->getNumContacts(); ++k) {
      contact_.touches |= manifold->getContactPoint(k).getDistance() < kTouchDistance_m;
    }
  }
  if (contact_.touches) contact_.impact_speed_m_s = std::max(descent_m_s, 0.0);
}

// Bullet moves the body with the velocity that it has after the step, x += T v(t+T). The trapezium rule is of
// second order: x += T (v(t) + v(t+T))/2, so half of the change is taken back, for the attitude as well.
void RigidBody::World::undo_half_step(const BodyState& before) {
  state_.p_WB -= 0.5 * kStep_s * (state_.v_W - before.v_W);
  state_.q_WB = (state_.q_WB * rotation(-0.5 * kStep_s * (state_.w_B - before.w_B))).normalized();
  state_.w_B = state_.q_WB.conjugate() * from_bullet(body_.getAngularVelocity());
  write_pose();
}

void RigidBody::World::write_pose() {
  const btTransform pose(to_bullet(state_.q_WB), to_bullet(state_.p_WB));
  body_.setWorldTransform(pose);
  body_.setInterpolationWorldTransform(pose);
}

RigidBody::RigidBody(const AirframeParameters& airframe, const BodyState& start)
    : world_((let_allocations_throw(), std::make_unique<World>(airframe, start))) {}
RigidBody::~RigidBody() = default;
RigidBody::RigidBody(RigidBody&&) noexcept = default;
RigidBody& RigidBody::operator=(RigidBody&&) noexcept = default;

void RigidBody::step(const Wrench& wrench) {
  world_->step(wrench);
}
const BodyState& RigidBody::state() const {
  return world_->state();
}
BodyState RigidBody::mid_step_state() const {
  return world_->mid_step_state();
}
const GroundContact& RigidBody::ground_contact() const {
  return world_->contact();
}

}  // namespace lineservo::vehicle
