#include "features/line/stripe_stand_in.h"

#include <gtest/gtest.h>

#include <cmath>

#include "features/geometry/angles.h"

namespace lineservo::features {
namespace {

/// A line through the view with its ends half a unit from the foot.
LineFeature line(double rho, double theta_deg, double width = 0.0) {
  LineFeature line;
  line.rho = rho;
  line.theta_rad = radians(theta_deg);
  line.width = width;
  const Eigen::Vector2d normal(std::cos(line.theta_rad), std::sin(line.theta_rad));
  const Eigen::Vector2d forward(normal.y(), -normal.x());
  const Eigen::Vector2d begin = rho * normal - 0.5 * forward, end = rho * normal + 0.5 * forward;
  line.begin = {begin.x(), begin.y()};
  line.end = {end.x(), end.y()};
  return line;
}

const LineFeature kAhead = line(0.02, 1.0, 0.7), kAcross = line(-0.3, 89.0, 0.7);

std::vector<double> offsets(const std::vector<LineFeature>& lines) {
  std::vector<double> rho;
  for (const LineFeature& l : lines) rho.push_back(l.rho);
  return rho;
}

using Offsets = std::vector<double>;

TEST(StripeStandIn, ALineAlongAStripeTakesItsPlaceWhereStripesMeet) {
  const LineFeature told = line(0.05, 4.0);
  EXPECT_EQ(offsets(with_stripes({told}, {kAhead, kAcross}, LinesMeet::yes)), (Offsets{0.05, -0.3}));
  EXPECT_EQ(offsets(with_stripes({told}, {kAcross, kAhead}, LinesMeet::yes)), (Offsets{-0.3, 0.05}));
}

TEST(StripeStandIn, ABorderCountsAsAlong) {
  EXPECT_EQ(offsets(with_stripes({line(-0.33, 1.0)}, {kAhead, kAcross}, LinesMeet::yes)),
            (Offsets{-0.33, -0.3}));
}

TEST(StripeStandIn, AMixtureOfStripesThatMeetGivesWayToThem) {
  const Offsets as_they_are = {0.02, -0.3};
  EXPECT_EQ(offsets(with_stripes({line(0.0, 40.0)}, {kAhead, kAcross}, LinesMeet::yes)), as_they_are);
  EXPECT_EQ(offsets(with_stripes({line(0.45, 1.0)}, {kAhead, kAcross}, LinesMeet::yes)), as_they_are);
  EXPECT_EQ(offsets(with_stripes({}, {kAhead, kAcross}, LinesMeet::yes)), as_they_are);
}

TEST(StripeStandIn, TheSideArmAloneIsNotTakenForTheLineAhead) {
  EXPECT_EQ(offsets(with_stripes({line(-0.31, 88.0)}, {kAhead, kAcross}, LinesMeet::yes)),
            (Offsets{0.02, -0.31}));
}

// (ρ, θ) and (−ρ, θ + π) are the same line.
TEST(StripeStandIn, KnowsALineOnItsOtherBranch) {
  EXPECT_EQ(offsets(with_stripes({line(0.31, -89.0)}, {kAhead, kAcross}, LinesMeet::yes)),
            (Offsets{0.02, 0.31}));
}

TEST(StripeStandIn, WithoutAJunctionTheMethodIsTakenAtItsWord) {
  const LineFeature beside = line(0.6, 0.0, 0.1);
  EXPECT_EQ(offsets(with_stripes({line(0.0, 40.0)}, {kAhead}, LinesMeet::no)), (Offsets{0.0, 0.02}));
  EXPECT_EQ(offsets(with_stripes({line(0.05, 1.0)}, {kAhead, beside}, LinesMeet::no)), (Offsets{0.05, 0.6}));
  EXPECT_TRUE(with_stripes({}, {kAhead, beside}, LinesMeet::no).empty());
}

}  // namespace
}  // namespace lineservo::features
