#pragma once

#include <Eigen/Eigenvalues>
#include <cmath>
#include <vector>

namespace lineservo::servo::testing {

/// The lateral loop of IbvsLineLaw as a linear sampled system; the derivation is in servo/law/stability.md.
struct LoopParameters {
  int frame_steps = 30;         ///< of kStep_s between two frames
  int delay_steps = 15;         ///< of the frames that the law knows of
  int unknown_delay_steps = 0;  ///< that it does not know of, and that shifts the frames alone
  double gain_per_s = 2.0;
  double drift_time_constant_s = 0.25;
  double answer_rad_s = 8.04;  ///< ω of the velocity answer ω² / (s² + 2ζω s + ω²)
  double answer_damping = 0.85;
};

/// The loop's state and one frame period of it.
class ClosedLoop {
 public:
  static constexpr double kStep_s = 1.0 / 300.0;

  explicit ClosedLoop(const LoopParameters& p)
      : p_(p), history_(static_cast<std::size_t>(p.delay_steps + p.unknown_delay_steps + 1), 0.0) {}

  std::size_t size() const { return history_.size() + 6; }
  double offset_m() const { return history_.front(); }
  double velocity_m_s() const { return velocity_; }

  /// At rest at an offset, seen for long.
  void rest_at(double offset_m) {
    *this = ClosedLoop(p_);
    std::fill(history_.begin(), history_.end(), offset_m);
    filtered_ = reckoned_ = offset_m;
  }

  void frame_period() {
    control();
    for (int k = 0; k < p_.frame_steps; ++k) vehicle_step();
  }

  /// The monodromy matrix of a frame period: its eigenvalues are the closed-loop poles.
  Eigen::MatrixXd monodromy() const {
    const auto n = static_cast<Eigen::Index>(size());
    Eigen::MatrixXd M(n, n);
    for (Eigen::Index k = 0; k < n; ++k) {
      ClosedLoop loop(p_);
      loop.set(Eigen::VectorXd::Unit(n, k));
      loop.frame_period();
      M.col(k) = loop.get();
    }
    return M;
  }

  /// The largest pole's modulus.
  double spectral_radius() const {
    return Eigen::EigenSolver<Eigen::MatrixXd>(monodromy(), false).eigenvalues().cwiseAbs().maxCoeff();
  }

 private:
  double before(int steps) const { return history_[static_cast<std::size_t>(steps)]; }

  // The odometry is exact, so that it differs from the offset by a constant that cancels.
  void control() {
    const double period_s = p_.frame_steps * kStep_s;
    const double p = std::exp(-period_s / p_.drift_time_constant_s);
    const double seen = before(p_.delay_steps + p_.unknown_delay_steps), reckoned = before(p_.delay_steps);
    const double predicted = filtered_ + (reckoned - reckoned_) + drift_ * period_s;
    const double residual = seen - predicted;
    filtered_ = predicted + (1.0 - p * p) * residual;
    drift_ += (1.0 - p) * (1.0 - p) * residual / period_s;
    reckoned_ = reckoned;
    command_ = -p_.gain_per_s * (seen + before(0) - reckoned) - drift_;
  }

  void vehicle_step() {
    const double w = p_.answer_rad_s;
    acceleration_ += kStep_s * (w * w * (command_ - velocity_) - 2.0 * p_.answer_damping * w * acceleration_);
    velocity_ += kStep_s * acceleration_;
    history_.insert(history_.begin(), before(0) + kStep_s * velocity_);
    history_.pop_back();
  }

  void set(const Eigen::VectorXd& x) {
    const auto n = static_cast<Eigen::Index>(history_.size());
    for (Eigen::Index k = 0; k < n; ++k) history_[static_cast<std::size_t>(k)] = x[k];
    velocity_ = x[n], acceleration_ = x[n + 1], filtered_ = x[n + 2], drift_ = x[n + 3], reckoned_ = x[n + 4],
    command_ = x[n + 5];
  }
  Eigen::VectorXd get() const {
    Eigen::VectorXd x(static_cast<Eigen::Index>(size()));
    const auto n = static_cast<Eigen::Index>(history_.size());
    for (Eigen::Index k = 0; k < n; ++k) x[k] = history_[static_cast<std::size_t>(k)];
    x.tail(6) << velocity_, acceleration_, filtered_, drift_, reckoned_, command_;
    return x;
  }

  LoopParameters p_;
  std::vector<double> history_;  ///< of the offset, the newest first
  double velocity_ = 0.0, acceleration_ = 0.0;
  double filtered_ = 0.0, drift_ = 0.0, reckoned_ = 0.0;  ///< of the drift observer
  double command_ = 0.0;
};

}  // namespace lineservo::servo::testing
