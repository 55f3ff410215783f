#pragma once

#include <optional>
#include <vector>

#include "servo/plan/topology.h"

namespace lineservo::servo {

/// A walk over the floor: the arms taken, in order; the first leaves the start node.
using Route = std::vector<TopologyArm>;

/// The shortest route between two nodes without turning back on an edge; of equally short ones that with the
/// fewest turns, then the one whose first edge is nearest to the +x direction (data/README.md: zone a along
/// row 0 first, zones b and c counter-clockwise on a tie). From a node to itself it is the shortest round.
/// For a traveller who stands on the start and faces a direction already, turning off it is a turn too, and
/// the first edge that is nearest to it goes before; turning round is allowed there. nullopt when there is
/// none.
std::optional<Route> shortest_route(const Topology& topology, std::size_t start, std::size_t target,
                                    std::optional<double> facing_rad = std::nullopt);

}  // namespace lineservo::servo
