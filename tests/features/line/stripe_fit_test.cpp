#include "features/line/stripe_fit.h"

#include <gtest/gtest.h>

#include "features/geometry/angles.h"

namespace lineservo::features {
namespace {

/// Points exactly on both borders of a stripe, `per_border` on each.
std::vector<BorderPoint> borders_of(const StripeCourse& course, int per_border) {
  const StripeAxes axes(course);
  std::vector<BorderPoint> points;
  for (int k = 0; k < per_border; ++k) {
    const double along = -0.7 + 1.4 * k / (per_border - 1);
    for (const double side : {-0.5, 0.5})
      points.push_back({axes.at(along, side * course.width), axes.normal() * (side > 0.0 ? -1.0 : 1.0),
                        course.theta_rad, 1.4 / per_border});
  }
  return points;
}

TEST(StripeFit, RecoversAnExactStripeFromANearbyStart) {
  const StripeCourse truth{.theta_rad = 0.2, .rho = 0.1, .width = 0.3};
  const auto fit = fit_stripe(borders_of(truth, 50), {0.21, 0.105, 0.31}, WidthIs::free);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->course.theta_rad, 0.2, 1e-9);
  EXPECT_NEAR(fit->course.rho, 0.1, 1e-9);
  EXPECT_NEAR(fit->course.width, 0.3, 1e-9);
  EXPECT_NEAR(fit->rising_length, 1.4, 1e-9);
  EXPECT_NEAR(fit->falling_length, 1.4, 1e-9);
}

TEST(StripeFit, BringsThetaIntoItsHalfTurnAndKeepsTheLine) {
  const StripeCourse truth{.theta_rad = radians(89.0), .rho = 0.1, .width = 0.2};
  const auto fit = fit_stripe(borders_of(truth, 50), {radians(89.5) - kPi, -0.1, 0.2}, WidthIs::free);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->course.theta_rad, radians(89.0), 1e-9);
  EXPECT_NEAR(fit->course.rho, 0.1, 1e-9);
}

TEST(StripeFit, OneBorderAndAKnownWidthGiveTheCentreline) {
  const StripeCourse truth{.theta_rad = -0.1, .rho = 0.2, .width = 0.4};
  std::vector<BorderPoint> points;
  for (const BorderPoint& point : borders_of(truth, 60))
    if (StripeAxes(truth).across(point.p_L) < 0.0) points.push_back(point);
  EXPECT_FALSE(fit_stripe(points, truth, WidthIs::free));
  const auto fit = fit_stripe(points, {-0.09, 0.21, 0.4}, WidthIs::known);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->course.rho, 0.2, 1e-9);
  EXPECT_NEAR(fit->course.theta_rad, -0.1, 1e-9);
  EXPECT_EQ(fit->course.width, 0.4);
}

TEST(StripeFit, OutliersAQuarterOfThePointsDoNotMoveIt) {
  const StripeCourse truth{.theta_rad = 0.0, .rho = 0.0, .width = 0.3};
  std::vector<BorderPoint> points = borders_of(truth, 60);
  for (std::size_t k = 0; k < points.size(); k += 4) points[k].p_L.x() += 0.025;
  const auto fit = fit_stripe(points, truth, WidthIs::free);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->course.rho, 0.0, 5e-4);
  EXPECT_NEAR(fit->course.theta_rad, 0.0, 5e-4);
}

TEST(StripeFit, TooFewPointsAreNoStripe) {
  const StripeCourse truth{.theta_rad = 0.0, .rho = 0.0, .width = 0.3};
  EXPECT_FALSE(fit_stripe({}, truth, WidthIs::free));
  EXPECT_FALSE(fit_stripe(borders_of(truth, 3), truth, WidthIs::free));
  EXPECT_TRUE(fit_stripe(borders_of(truth, 4), truth, WidthIs::free));
}

}  // namespace
}  // namespace lineservo::features
