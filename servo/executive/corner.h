#pragma once

#include <Eigen/Core>

#include "features/geometry/angles.h"

namespace lineservo::servo {

/// Which turns are rounded without a stop, and how widely.
struct CornerOptions {
  double deviation_m = 0.02;       ///< of the arc from the two edges, at most; 0: every turn is made at rest
  double acceleration_m_s2 = 0.5;  ///< towards the arc's centre
  double turn_max_rad = features::radians(100.0);  ///< what turns further is not rounded
};

/// How a corner is rounded: v = √(a·R), with an arc that keeps near to the edges.
struct CornerArc {
  double radius_m = 0.0;
  double speed_m_s = 0.0;
};

/// The arc for a turn at a speed. It leaves the edges by R (1 − cos β/2): the radius is the smaller of what
/// the speed needs, v²/a, and what the deviation allows; then the speed follows the radius.
CornerArc corner_arc(double turn_rad, double speed_m_s, const CornerOptions& options);

/// The same for a node that is so near already: an arc that begins no earlier than here.
CornerArc shortened(const CornerArc& arc, double turn_rad, double ahead_m, const CornerOptions& options);

/// The way round a corner: along the edge, on an arc that touches both edges, along the next edge. A way is
/// measured along it in metres, 0 in the middle of the arc. Any planar frame, metres.
class CornerPath {
 public:
  CornerPath(const Eigen::Vector2d& node_m, double heading_in_rad, double turn_rad, double radius_m);

  /// The way of the place on the path that is nearest to a point.
  double nearest_way_m(const Eigen::Vector2d& p_m) const;
  Eigen::Vector2d point_m(double way_m) const;
  double heading_rad(double way_m) const;
  /// The way of the arc's end; it begins at the negative of it.
  double arc_end_m() const { return half_arc_m_; }

 private:
  double nearest_on_arc_m(const Eigen::Vector2d& p_m) const;

  double heading_in_rad_, turn_rad_, radius_m_, half_arc_m_;
  Eigen::Vector2d along_in_, along_out_;
  Eigen::Vector2d arc_begin_m_, arc_end_point_m_, centre_m_;
};

}  // namespace lineservo::servo
