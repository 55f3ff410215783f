#include "vehicle/body/flight_dynamics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lineservo::vehicle {
namespace {

/// A second model of the same vehicle, written on its own: states in one vector (p, q as wxyz, v, w, rotor
/// speeds), Runge–Kutta of fourth order. No floor and no ground effect.
class Twin {
 public:
  using State = Eigen::Matrix<double, 17, 1>;

  Twin(const AirframeParameters& a, const BodyState& start, const Eigen::Vector3d& wind_W)
      : a_(a), wind_W_(wind_W) {
    x_.setZero();
    x_.segment<3>(0) = start.p_WB;
    x_[3] = 1.0;
  }

  void advance(double T, const PerRotor& command) {
    const State k1 = derivative(x_, command), k2 = derivative(x_ + T / 2 * k1, command);
    const State k3 = derivative(x_ + T / 2 * k2, command), k4 = derivative(x_ + T * k3, command);
    x_ += T / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    x_.segment<4>(3).normalize();
  }

  Eigen::Vector3d position() const { return x_.segment<3>(0); }
  Eigen::Vector3d velocity() const { return x_.segment<3>(7); }
  Eigen::Vector3d body_rate() const { return x_.segment<3>(10); }
  Eigen::Quaterniond attitude() const { return {x_[3], x_[4], x_[5], x_[6]}; }

 private:
  State derivative(const State& x, const PerRotor& command) const {
    const Eigen::Quaterniond q(x[3], x[4], x[5], x[6]);
    const Eigen::Matrix3d R = q.normalized().toRotationMatrix();
    const Eigen::Vector3d v = x.segment<3>(7), w = x.segment<3>(10), I = a_.inertia_kg_m2;
    const Eigen::Vector3d air = R.transpose() * (v - wind_W_);
    Eigen::Vector3d F = -0.5 * 1.225 * a_.body_drag_area_m2 * air.norm() * air, M = Eigen::Vector3d::Zero();
    for (int i = 0; i < 4; ++i) {
      const auto& rotor = a_.rotors[static_cast<std::size_t>(i)];
      const double n = x[13 + i], T = a_.thrust_coefficient_N_s2 * n * n;
      const double cd = a_.rotor_drag_N_per_rad_s_m_s * n;
      const double fx = -cd * (air.x() - w.z() * rotor.y_m), fy = -cd * (air.y() + w.z() * rotor.x_m);
      F += Eigen::Vector3d(fx, fy, T);
      M += Eigen::Vector3d(rotor.y_m * T, -rotor.x_m * T,
                           rotor.x_m * fy - rotor.y_m * fx - rotor.spin_sign() * a_.moment_coefficient_m * T);
    }
    State dx;
    dx.segment<3>(0) = v;
    const Eigen::Quaterniond dq = q * Eigen::Quaterniond(0.0, w.x(), w.y(), w.z());
    dx.segment<4>(3) << dq.w() / 2, dq.x() / 2, dq.y() / 2, dq.z() / 2;
    dx.segment<3>(7) = R * F / a_.mass_kg - Eigen::Vector3d(0, 0, 9.81);
    dx.segment<3>(10) = (M - w.cross(I.cwiseProduct(w))).cwiseQuotient(I);
    for (int i = 0; i < 4; ++i) {
      const double behind = command[i] - x[13 + i];
      dx[13 + i] = behind / (behind > 0 ? a_.motor_lag_up_s : a_.motor_lag_down_s);
    }
    return dx;
  }

  AirframeParameters a_;
  Eigen::Vector3d wind_W_;
  State x_;
};

/// Far from the floor, whose ground effect the twin has not.
BodyState high_up() {
  BodyState state;
  state.p_WB.z() = 5000.0;
  return state;
}

PerRotor manoeuvre_rad_s(const AirframeParameters& a, double t_s) {
  PerRotor command;
  for (int i = 0; i < 4; ++i) {
    command[i] = a.hover_speed_rad_s() * (1.0 + 0.004 * std::cos(2.0 * t_s + 1.5 * i) + 0.001 * (i < 2));
  }
  return command;
}

TEST(FlightDynamics, AgreesWithAnIndependentModelOverTenSecondsOfTumbling) {
  const AirframeParameters iris;
  const Eigen::Vector3d wind_W(1.0, 0.5, 0.0);
  FlightDynamics dynamics(iris, high_up());
  Twin twin(iris, high_up(), wind_W);
  double farthest_m = 0.0, travelled_m = 0.0;
  for (int i = 0; i < 10000; ++i) {
    const PerRotor command = manoeuvre_rad_s(iris, 1e-3 * i);
    dynamics.step(command, wind_W);
    twin.advance(1e-3, command);
    farthest_m = std::max(farthest_m, (dynamics.state().p_WB - twin.position()).norm());
    travelled_m += 1e-3 * twin.velocity().norm();
  }
  EXPECT_LT(farthest_m, 2e-3);
  EXPECT_LT((dynamics.state().v_W - twin.velocity()).norm(), 2e-3);
  EXPECT_LT((dynamics.state().w_B - twin.body_rate()).norm(), 1e-3);
  EXPECT_LT(dynamics.state().q_WB.angularDistance(twin.attitude()), 1e-3);
  EXPECT_GT(travelled_m, 50.0);  // open loop it turns over and falls: all terms have worked
  EXPECT_GT(twin.body_rate().norm(), 0.1);
}

TEST(FlightDynamics, FallingItReachesTheTerminalVelocityOfItsDrag) {
  AirframeParameters brick;
  brick.body_drag_area_m2 = 0.5;
  FlightDynamics dynamics(brick, high_up());
  for (int i = 0; i < 10000; ++i) dynamics.step(PerRotor::Zero(), Eigen::Vector3d::Zero());
  EXPECT_NEAR(dynamics.state().v_W.z(), -std::sqrt(2 * 1.5 * 9.81 / (1.225 * 0.5)), 1e-3);
}

TEST(FlightDynamics, TheWindTakesItAlong) {
  const AirframeParameters iris;
  FlightDynamics dynamics(iris, high_up());
  const Eigen::Vector3d wind_W(2.0, -1.0, 0.0);
  for (int i = 0; i < 30000; ++i) dynamics.step(PerRotor::Constant(iris.hover_speed_rad_s()), wind_W);
  EXPECT_NEAR((dynamics.state().v_W - wind_W).head<2>().norm(), 0.0, 1e-2);
}

}  // namespace
}  // namespace lineservo::vehicle
