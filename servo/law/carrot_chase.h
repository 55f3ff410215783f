#pragma once

#include <Eigen/Core>
#include <optional>

#include "servo/law/observation.h"

namespace lineservo::servo {

/// W_i and W_i+1 of lfpf in its pixels: forward, left of the image's centre p.
struct CarrotPath {
  Eigen::Vector2d behind_px;
  Eigen::Vector2d ahead_px;
};

/// The way-points seen (lfpf §3.3.2); over a junction, where the boundary shows its arms as well, the ends of
/// the line that is followed. When only one is, the image's centre stands for the other: the vehicle then
/// keeps to the bearing of what it sees. None when there is none, or both are one point.
std::optional<CarrotPath> carrot_path(const Observation& observation);

/// lfpf Alg. 1 without its gain: ψ_d − ψ, how far to the left to turn so as to head for the point that lies δ
/// pixels ahead on the line through the way-points. In (−π, π].
double carrot_turn_rad(const CarrotPath& path, double delta_px);

}  // namespace lineservo::servo
