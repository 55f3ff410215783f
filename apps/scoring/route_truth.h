#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "servo/plan/plan.h"
#include "vehicle/floor/layout.h"

namespace lineservo::apps {

/// One edge of the route as it is travelled.
struct TravelledEdge {
  const vehicle::Curve* curve = nullptr;
  bool reversed = false;
};

/// The point of an edge at an arc length, as travelled.
vehicle::CurvePoint travelled_point(const TravelledEdge& edge, double arc_length_m);

/// A stretch between two turns, in true coordinates: for scoring only.
struct LegTruth {
  std::string from, to;
  std::vector<TravelledEdge> edges;
  double start_heading_rad = 0.0;
  double end_heading_rad = 0.0;
  std::string axis;  ///< "x", "y", or "" when it is neither
};

/// Where a place lies against a leg: the nearest point of its centreline. Before the leg's beginning the
/// first edge is taken as going on straight backward; its end is an end.
struct LegOffset {
  double distance_m = 0.0;
  double signed_m = 0.0;  ///< positive to the left of travel
};
LegOffset offset_from(const LegTruth& leg, const Eigen::Vector2d& p_W);
/// The same with the leg's beginning as an end, too: for a turn onto it.
LegOffset offset_after_node(const LegTruth& leg, const Eigen::Vector2d& p_W);

/// The true way of a flight.
struct RouteTruth {
  std::vector<LegTruth> legs;
  std::vector<int> closing_steps;    ///< index of the plan's step that ends the leg: a turn, or the last
  std::vector<bool> closed_by_stop;  ///< whether that step is a target: the leg ends before its hover
  std::vector<std::size_t> nodes;    ///< of the layout, of each plan step
  std::size_t target = 0;
};

/// The way that a plan takes over a layout; its edges must be those of the layout that the plan was compiled
/// for.
RouteTruth route_truth(const vehicle::Layout& layout, const servo::Plan& plan);

}  // namespace lineservo::apps
