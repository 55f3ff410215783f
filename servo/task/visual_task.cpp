#include "servo/task/visual_task.h"

#include <visp3/vs/vpServo.h>

#include <cmath>

namespace lineservo::servo {
namespace {

/// Rotation of the heading frame seen from the level camera: x_C = −y_H, y_C = −x_H, z_C = −z_H.
vpVelocityTwistMatrix level_cVe() {
  vpRotationMatrix R_CH;
  R_CH[0][0] = 0, R_CH[0][1] = -1, R_CH[0][2] = 0;
  R_CH[1][0] = -1, R_CH[1][1] = 0, R_CH[1][2] = 0;
  R_CH[2][0] = 0, R_CH[2][1] = 0, R_CH[2][2] = -1;
  return vpVelocityTwistMatrix(vpTranslationVector(0, 0, 0), R_CH);
}

/// A level quadrotor moves in x, y, z and yaw: 6×4, twist (v, ω). A yaw that is held is no motion of the
/// task's.
vpMatrix level_eJe(VisualTask::Yaw yaw) {
  vpMatrix eJe(6, 4);
  eJe[0][0] = eJe[1][1] = eJe[2][2] = 1.0;
  eJe[5][3] = yaw == VisualTask::Yaw::commanded ? 1.0 : 0.0;
  return eJe;
}

vpServo::vpServoIteractionMatrixType to_visp(InteractionMatrix matrix) {
  switch (matrix) {
    case InteractionMatrix::desired:
      return vpServo::DESIRED;
    case InteractionMatrix::mean:
      return vpServo::MEAN;
    case InteractionMatrix::current:
      break;
  }
  return vpServo::CURRENT;
}

vpColVector to_visp(const VelocityCommand& c) {
  vpColVector q(4);
  q[0] = c.forward_m_s;
  q[1] = c.left_m_s;
  q[2] = c.up_m_s;
  q[3] = c.yaw_rate_rad_s;
  return q;
}

VelocityCommand from_visp(const vpColVector& q) {
  return {q[0], q[1], q[2], q[3]};
}

Eigen::MatrixXd to_eigen(const vpMatrix& m) {
  return Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
      m.data, m.getRows(), m.getCols());
}

}  // namespace

struct VisualTask::Impl {
  explicit Impl(Yaw yaw) : eJe(level_eJe(yaw)) {}
  vpServo servo;
  const vpVelocityTwistMatrix cVe = level_cVe();
  const vpMatrix eJe;
  unsigned dimension = 0;
  ~Impl() { servo.kill(); }
};

VisualTask::VisualTask(const AdaptiveGain& gain, InteractionMatrix matrix, Yaw yaw)
    : impl_(std::make_unique<Impl>(yaw)) {
  impl_->servo.setServo(vpServo::EYEINHAND_L_cVe_eJe);
  impl_->servo.setInteractionMatrixType(to_visp(matrix), vpServo::PSEUDO_INVERSE);
  impl_->servo.setLambda(gain.at_zero, gain.at_infinity, gain.slope_at_zero);
}

VisualTask::~VisualTask() = default;

void VisualTask::add(vpBasicFeature& s, vpBasicFeature& s_star, unsigned select, unsigned dimension) {
  impl_->servo.addFeature(s, s_star, select);
  impl_->dimension += dimension;
}

TaskSolution VisualTask::solve(const VelocityCommand& secondary, const Eigen::VectorXd& error_rate) try {
  vpServo& servo = impl_->servo;
  servo.set_cVe(impl_->cVe);
  servo.set_eJe(impl_->eJe);
  vpColVector qdot = servo.computeControlLaw();
  const bool has_null_space = servo.getTaskRank() < servo.getTaskJacobian().getCols();
  if (has_null_space) qdot += servo.secondaryTask(to_visp(secondary));  // throws where nothing is free
  if (error_rate.size() > 0) {
    vpColVector rate(static_cast<unsigned>(error_rate.size()));
    for (unsigned i = 0; i < rate.size(); ++i) rate[i] = error_rate[i];
    qdot -= servo.getTaskJacobianPseudoInverse() * rate;
  }
  TaskSolution solution{from_visp(qdot), servo.getTaskRank(), false};
  solution.valid = solution.rank == impl_->dimension && is_finite(solution.command);
  return solution;
} catch (const vpException&) {
  return {};
}

Eigen::MatrixXd VisualTask::jacobian() const {
  return to_eigen(impl_->servo.getTaskJacobian());
}

Eigen::VectorXd VisualTask::error() const {
  const vpColVector e = impl_->servo.getError();
  return Eigen::Map<const Eigen::VectorXd>(e.data, e.size());
}

}  // namespace lineservo::servo
