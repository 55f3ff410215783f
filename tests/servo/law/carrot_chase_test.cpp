#include "servo/law/carrot_chase.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/servo/law/follower_views.h"

namespace lineservo::servo {
namespace {

using features::JunctionCode;
using testing::at_px;
using testing::boundary_view;

// A line forward, 50 px to the left: the carrot lies (100, 50) off, whatever lies behind.
TEST(CarrotChase, AParallelLineByHand) {
  EXPECT_NEAR(carrot_turn_rad({{-230.0, 50.0}, {230.0, 50.0}}, 100.0), std::atan2(50.0, 100.0), 1e-12);
  EXPECT_NEAR(carrot_turn_rad({{-230.0, -50.0}, {230.0, -50.0}}, 100.0), -std::atan2(50.0, 100.0), 1e-12);
}

// Through the centre at 30° to the left: the carrot lies on it.
TEST(CarrotChase, ALineThroughTheCentreIsTurnedOnto) {
  const double turn = std::numbers::pi / 6.0;
  const Eigen::Vector2d along(std::cos(turn), std::sin(turn));
  EXPECT_NEAR(carrot_turn_rad({-200.0 * along, 200.0 * along}, 100.0), turn, 1e-12);
}

// W_i = (−200, 80), W_i+1 = (200, −70): θ = atan2(−150, 400); the foot of p and the carrot by vectors alone.
TEST(CarrotChase, ASlantedLineByVectors) {
  const Eigen::Vector2d behind(-200.0, 80.0), ahead(200.0, -70.0);
  const Eigen::Vector2d t = (ahead - behind).normalized();
  const Eigen::Vector2d carrot = behind + (-behind.dot(t) + 100.0) * t;
  EXPECT_NEAR(carrot_turn_rad({behind, ahead}, 100.0), std::atan2(carrot.y(), carrot.x()), 1e-12);
}

TEST(CarrotChase, WayPointsAreForwardAndLeftInPixels) {
  const auto path = carrot_path(boundary_view(at_px(10.0, 230.0), at_px(-20.0, -230.0)));
  ASSERT_TRUE(path);
  EXPECT_NEAR((path->behind_px - Eigen::Vector2d(-230.0, -10.0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((path->ahead_px - Eigen::Vector2d(230.0, 20.0)).norm(), 0.0, 1e-9);
}

TEST(CarrotChase, OneWayPointIsABearing) {
  Observation o = boundary_view(at_px(0.0, 230.0), at_px(-100.0, -100.0));
  o.features.law.behind.reset();
  EXPECT_NEAR(carrot_turn_rad(*carrot_path(o), 100.0), std::numbers::pi / 4.0, 1e-9);
  o = boundary_view(at_px(-100.0, 100.0), at_px(0.0, -230.0));
  o.features.law.ahead.reset();
  EXPECT_NEAR(carrot_turn_rad(*carrot_path(o), 100.0), -std::numbers::pi / 4.0, 1e-9);
}

TEST(CarrotChase, NothingToGoBy) {
  EXPECT_FALSE(carrot_path(testing::empty_view()));
  EXPECT_FALSE(carrot_path(testing::empty_view(JunctionCode::cross)));
  EXPECT_FALSE(carrot_path(boundary_view(at_px(5.0, 5.0), at_px(5.0, 5.0))));
  Observation broken = testing::empty_view();
  broken.features.law.ahead = features::LevelPoint{std::nan(""), 0.0};
  EXPECT_FALSE(carrot_path(broken));
}

TEST(CarrotChase, OverAJunctionTheEndsOfTheLineThatIsLedAlong) {
  Observation o = boundary_view(at_px(0.0, 230.0), at_px(-300.0, -230.0));
  o.features.code.smoothed = JunctionCode::tee_left;
  EXPECT_FALSE(carrot_path(o));
  o.features.lines = {testing::line_through(at_px(0.0, 240.0), at_px(0.0, -240.0))};
  EXPECT_NEAR(carrot_turn_rad(*carrot_path(o), 100.0), 0.0, 1e-9);
}

}  // namespace
}  // namespace lineservo::servo
