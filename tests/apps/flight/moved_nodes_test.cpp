// No map at run time (data/README.md): a plan compiled from `warehouse` flies over a floor whose nodes lie
// elsewhere.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/apps/flight/test_flight.h"
#include "vehicle/random.h"

namespace lineservo::apps {
namespace {

using testing::Flown;
using testing::fly;
using testing::request_for;
using testing::shipped_layout;
using testing::story;

constexpr double kColumn_m = 3.6, kRow_m = 6.8 / 3.0;

/// The layout with its nodes moved by displace(node index), markers and straight edges with them.
template <typename Displace>
vehicle::Layout moved(vehicle::Layout layout, Displace displace) {
  const Eigen::Vector2d start_was = layout.nodes[layout.start].p_W;
  for (std::size_t i = 0; i < layout.nodes.size(); ++i) layout.nodes[i].p_W += displace(i);
  for (vehicle::LayoutMarker& marker : layout.start_markers)
    marker.p_W += layout.nodes[layout.start].p_W - start_was;
  for (vehicle::LayoutEdge& edge : layout.edges)
    edge.centreline = vehicle::Curve::line(layout.nodes[edge.from].p_W, layout.nodes[edge.to].p_W);
  return layout;
}

/// Every column and row moved as a whole, by up to a share of its spacing.
vehicle::Layout with_moved_lines(double share, std::uint64_t seed) {
  const vehicle::Layout layout = shipped_layout("warehouse");
  vehicle::Random random(seed, 0);
  std::array<double, 6> columns_m{};
  std::array<double, 5> rows_m{};
  for (double& d : columns_m) d = random.uniform(-share, share) * kColumn_m;
  for (double& d : rows_m) d = random.uniform(-share, share) * kRow_m;
  return moved(layout, [&](std::size_t i) {
    const Eigen::Vector2d p_W = layout.nodes[i].p_W;
    const auto column = static_cast<std::size_t>(std::lround((p_W.x() - 0.6) / kColumn_m));
    const auto row = static_cast<std::size_t>(std::lround((p_W.y() - 0.6) / kRow_m));
    return Eigen::Vector2d(columns_m[column], rows_m[row]);
  });
}

/// Every node moved on its own, along x and y, by up to a share of the shorter spacing.
vehicle::Layout with_moved_nodes(double share, std::uint64_t seed) {
  vehicle::Random random(seed, 0);
  return moved(shipped_layout("warehouse"), [&](std::size_t) {
    const double x_m = random.uniform(-share, share) * kRow_m;
    return Eigen::Vector2d(x_m, random.uniform(-share, share) * kRow_m);
  });
}

Flown fly_over(const vehicle::Layout& floor, const std::string& instruction, const std::string& conditions,
               std::uint64_t seed) {
  return fly(request_for(instruction, conditions, seed), shipped_layout("warehouse"), floor);
}

class MovedNodes : public ::testing::TestWithParam<std::tuple<std::string, std::uint64_t>> {
 protected:
  const std::string instruction_ = std::get<0>(GetParam());
  const std::uint64_t seed_ = std::get<1>(GetParam());
};

TEST_P(MovedNodes, ColumnsAndRowsByATenthOfTheirSpacing) {
  const Flown flown = fly_over(with_moved_lines(0.10, seed_), instruction_, "paper", seed_);
  ASSERT_EQ(flown.summary.outcome, "arrived") << story(flown);
  EXPECT_LT(flown.summary.rest->target_error_m, 0.05);
}

TEST_P(MovedNodes, EachOnItsOwnByATwentieth) {
  const Flown flown = fly_over(with_moved_nodes(0.05, seed_), instruction_, "paper", seed_);
  ASSERT_EQ(flown.summary.outcome, "arrived") << story(flown);
  EXPECT_LT(flown.summary.rest->target_error_m, 0.05);
}

class FarMovedNodes : public MovedNodes {};

TEST_P(FarMovedNodes, EachOnItsOwnByATenth) {
  const Flown flown = fly_over(with_moved_nodes(0.10, seed_), instruction_, "paper", seed_);
  ASSERT_EQ(flown.summary.outcome, "arrived") << story(flown);
  EXPECT_LT(flown.summary.rest->target_error_m, 0.05);
}

INSTANTIATE_TEST_SUITE_P(Warehouse, MovedNodes,
                         ::testing::Combine(::testing::Values("a03", "a13", "a23", "a53"),
                                            ::testing::Values(1u, 2u)));
INSTANTIATE_TEST_SUITE_P(Warehouse, FarMovedNodes,
                         ::testing::Combine(::testing::Values("a03", "a13", "a23", "a53"),
                                            ::testing::Values(1u, 2u, 3u)));

}  // namespace
}  // namespace lineservo::apps
