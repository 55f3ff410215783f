#include "vehicle/estimator/chain_filter.h"

namespace lineservo::vehicle {

ChainFilter::ChainFilter(double period_s, const Noise& noise, const Eigen::Vector3d& start,
                         const Eigen::Vector3d& start_sigma)
    : Q_(noise.drive * period_s),
      R_(noise.measurement_sigma * noise.measurement_sigma),
      x_(start),
      P_(start_sigma.cwiseAbs2().asDiagonal()) {
  // clang-format off
  F_ << 1, period_s, 0.5 * period_s * period_s,
        0, 1,        period_s,
        0, 0,        1;
  // clang-format on
}

// x ← F x + u,  P ← F P Fᵀ + Q
void ChainFilter::predict(const Eigen::Vector3d& known_change) {
  x_ = F_ * x_ + known_change;
  P_ = F_ * P_ * F_.transpose();
  P_.diagonal() += Q_;
}

// K = P Hᵀ/(H P Hᵀ + R),  x ← x + K (z − H x),  P ← P − K H P,  H = (1 0 0)
void ChainFilter::measure(double x0) {
  const Eigen::Vector3d K = P_.col(0) / (P_(0, 0) + R_);
  x_ += K * (x0 - x_[0]);
  const Eigen::RowVector3d HP = P_.row(0);
  P_ -= K * HP;
  P_ = 0.5 * (P_ + P_.transpose()).eval();
}

}  // namespace lineservo::vehicle
