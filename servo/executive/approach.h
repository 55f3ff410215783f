#pragma once

namespace lineservo::servo {

/// How the vehicle slows down before a place.
struct ApproachOptions {
  double deceleration_m_s2 = 0.5;  ///< before a place to be slow at
  double response_s = 0.2;         ///< until the vehicle answers to a lower speed
  double speed_m_s = 0.05;         ///< never slower than this before a node's code is confirmed
};

/// The speed now from which the vehicle has come down to `end_m_s` a way `ahead_m` further on: v with
/// v T + (v² − v_e²) / 2a = d. Past the place it is `end_m_s`. Never below the approach speed.
double braking_speed(double ahead_m, double end_m_s, const ApproachOptions& options);

}  // namespace lineservo::servo
