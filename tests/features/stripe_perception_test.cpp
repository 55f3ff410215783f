#include "features/stripe_perception.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/features/test_masks.h"

namespace lineservo::features {
namespace {

using test::blot;
using test::draw;
using test::Floor;
using test::kAhead;
using test::kBehind;
using test::kLeft;
using test::kRight;
using test::node_floor;
using test::Pose;
using test::straight_floor;
using test::TestMask;
using test::TestRandom;
using test::true_course;

constexpr double kBroad_m = 0.36, kTape_m = 0.05;

class Perception : public testing::Test {
 protected:
  const StripeFeatures& see(const TestMask& mask, const Pose& pose,
                            const std::optional<StripePrior>& prior = std::nullopt) {
    return perception_.observe(mask.view(), pose.view(), prior);
  }
  const StripeFeatures& see(const Floor& floor, const Pose& pose) {
    return see(draw(geometry_, pose, floor), pose);
  }

  MaskGeometry geometry_{CameraModel{CameraParameters{}}, test::kMaskSize, test::kMaskSize};
  StripePerception perception_{geometry_};
};

/// Mean squares of what is measured.
class Rms {
 public:
  void add(double error) {
    squares_ += error * error;
    ++count_;
  }
  double value() const { return std::sqrt(squares_ / count_); }

 private:
  double squares_ = 0.0;
  int count_ = 0;
};

TEST_F(Perception, StraightLinesAreExactOverAGridOfPoses) {
  for (const double width : {kBroad_m, kTape_m}) {
    TestRandom random(1);
    Rms rho, theta, rho_in_sigma, theta_in_sigma;
    for (int k = 0; k < 60; ++k) {
      const Pose pose{.y_m = random.uniform(-0.1, 0.1),
                      .height_m = random.uniform(0.45, 1.5),
                      .heading_rad = random.uniform(-0.52, 0.52),
                      .roll_rad = random.uniform(-0.087, 0.087),
                      .pitch_rad = random.uniform(-0.087, 0.087)};
      const StripeFeatures& seen = see(straight_floor(width), pose);
      ASSERT_EQ(seen.lines.size(), 1u) << k;
      EXPECT_FALSE(seen.junction);
      EXPECT_FALSE(seen.line_ends_ahead);
      const LineFeature& line = seen.lines.front();
      const Eigen::Vector2d error =
          test::course_error(line.rho, line.theta_rad, true_course(pose, {0.0, 0.0}, 0.0, width));
      rho.add(error.x());
      theta.add(error.y());
      rho_in_sigma.add(error.x() / std::sqrt(line.covariance(0, 0)));
      theta_in_sigma.add(error.y() / std::sqrt(line.covariance(1, 1)));
      EXPECT_NEAR(line.width, width / pose.height_m, 3e-3);
      EXPECT_GT(line.quality, 0.8);
      EXPECT_LT(line.end.y, line.begin.y);
    }
    EXPECT_LT(rho.value(), 3e-4);  // 0.15 mm from 0.5 m
    EXPECT_LT(theta.value(), radians(0.04));
    EXPECT_LT(rho_in_sigma.value(), 1.0);
    EXPECT_LT(theta_in_sigma.value(), 1.2);
  }
}

TEST_F(Perception, ThetaWrapsAtNinetyDegreesAndTheLineStays) {
  for (const double yaw_deg : {88.0, 89.5, 90.5, 92.0, -89.0, -91.0}) {
    const Pose pose{.x_m = 0.0, .y_m = 0.06, .heading_rad = radians(yaw_deg)};
    const StripeFeatures& seen = see(straight_floor(kTape_m), pose);
    ASSERT_EQ(seen.lines.size(), 1u);
    const LineFeature& line = seen.lines.front();
    EXPECT_GT(line.theta_rad, -kPi / 2.0);
    EXPECT_LE(line.theta_rad, kPi / 2.0);
    const StripeCourse truth = true_course(pose, {0.0, 0.0}, 0.0, kTape_m);
    const Eigen::Vector2d error = test::course_error(line.rho, line.theta_rad, truth);
    EXPECT_NEAR(error.x(), 0.0, 2e-3);
    EXPECT_NEAR(error.y(), 0.0, radians(0.15));
    EXPECT_EQ(seen.raw, JunctionCode::straight);
  }
}

TEST_F(Perception, ALensThatDistortsIsTakenOutOfThePoints) {
  CameraParameters bent;
  bent.distortion = {-0.1, 0.02, 1e-3, -5e-4, 0.0};
  const MaskGeometry geometry(CameraModel{bent}, test::kMaskSize, test::kMaskSize);
  StripePerception perception(geometry);
  const Pose pose{.y_m = 0.07, .heading_rad = 0.2, .roll_rad = 0.05};
  const TestMask mask = draw(geometry, pose, straight_floor(kBroad_m));
  const StripeFeatures& seen = perception.observe(mask.view(), pose.view());
  ASSERT_EQ(seen.lines.size(), 1u);
  const Eigen::Vector2d error = test::course_error(seen.lines[0].rho, seen.lines[0].theta_rad,
                                                   true_course(pose, {0.0, 0.0}, 0.0, kBroad_m));
  EXPECT_NEAR(error.x(), 0.0, 1e-3);
  EXPECT_NEAR(error.y(), 0.0, radians(0.1));
}

struct NodeCase {
  const char* name;
  std::vector<double> arms;
  int first_cm, last_cm;  ///< of the vehicle's way along +x
};

class Passing : public Perception, public testing::WithParamInterface<std::tuple<NodeCase, double>> {};

// Along the line through the node, with the jitter of a flight: every frame outside of the 4-px band reads
// the true code, and the centre of the junction is where the node is.
TEST_P(Passing, ReadsTheCodeAndPlacesTheNode) {
  const auto& [node, width] = GetParam();
  const Floor floor = node_floor(node.arms, width);
  TestRandom random(7);
  Rms centre_m;
  int clear = 0, right = 0;
  for (int cm = node.first_cm; cm <= node.last_cm; ++cm) {
    const Pose pose{.x_m = 0.01 * cm,
                    .y_m = random.uniform(-0.1, 0.1),
                    .heading_rad = random.uniform(-0.07, 0.07),
                    .roll_rad = random.uniform(-0.035, 0.035),
                    .pitch_rad = random.uniform(-0.035, 0.035)};
    const StripeFeatures& seen = see(floor, pose);
    const test::CodeTruth truth = test::true_code(geometry_, pose, floor);
    if (truth.margin_px >= 4.0) {
      ++clear;
      right += int{seen.raw == truth.code};
    }
    if (seen.junction) centre_m.add((seen.junction->centre.vector() - pose.level({0.0, 0.0})).norm() * 0.5);
    ASSERT_FALSE(seen.lines.empty());
  }
  ASSERT_GT(clear, 15);
  EXPECT_EQ(right, clear);
  EXPECT_LT(centre_m.value(), 0.001);
}

INSTANTIATE_TEST_SUITE_P(
    All, Passing,
    testing::Combine(testing::Values(NodeCase{"cross", {kAhead, kBehind, kLeft, kRight}, -70, 70},
                                     NodeCase{"tee_left", {kAhead, kBehind, kLeft}, -70, 70},
                                     NodeCase{"tee_right", {kAhead, kBehind, kRight}, -70, 70},
                                     NodeCase{"tee_end", {kBehind, kLeft, kRight}, -70, 0},
                                     NodeCase{"corner_left", {kBehind, kLeft}, -70, 0},
                                     NodeCase{"corner_right", {kBehind, kRight}, -70, 0},
                                     NodeCase{"corner_left_behind", {kAhead, kLeft}, 0, 70},
                                     NodeCase{"corner_right_behind", {kAhead, kRight}, 0, 70}),
                     testing::Values(kBroad_m, kTape_m)),
    [](const auto& test_case) {
      return std::string(std::get<0>(test_case.param).name) +
             (std::get<1>(test_case.param) > 0.1 ? "_broad" : "_tape");
    });

TEST_F(Perception, OverACornerBothStripesAreSeenAndTheLineEnds) {
  for (const double width : {kBroad_m, kTape_m}) {
    const Pose pose{.x_m = -0.06, .y_m = 0.03, .heading_rad = 0.05};
    const StripeFeatures& seen = see(node_floor({kBehind, kLeft}, width), pose);
    ASSERT_EQ(seen.lines.size(), 2u);
    EXPECT_NEAR(seen.lines[0].theta_rad, 0.05, radians(0.3));
    EXPECT_TRUE(seen.line_ends_ahead);
    ASSERT_TRUE(seen.junction);
    ASSERT_EQ(seen.junction->arms.size(), 2u);
    EXPECT_NEAR(wrap_angle(seen.junction->arms[0].angle_rad - (kPi - 0.05)), 0.0, radians(0.3));
    EXPECT_NEAR(wrap_angle(seen.junction->arms[1].angle_rad - (kPi / 2.0 - 0.05)), 0.0, radians(0.3));
  }
}

TEST_F(Perception, A45DegreeBendIsAJunctionWithItsAngle) {
  for (const double turn : {radians(45.0), -radians(45.0)}) {
    const Pose pose{.x_m = -0.15, .y_m = 0.02, .height_m = 0.8};
    const StripeFeatures& seen = see(node_floor({kBehind, turn}, 0.2), pose);
    ASSERT_TRUE(seen.junction);
    ASSERT_EQ(seen.junction->arms.size(), 2u);
    EXPECT_NEAR(std::abs(seen.junction->arms[0].angle_rad), kPi, radians(0.3));
    EXPECT_NEAR(seen.junction->arms[1].angle_rad, turn, radians(0.3));
    EXPECT_NEAR((seen.junction->centre.vector() - pose.level({0.0, 0.0})).norm(), 0.0, 3e-3);
    EXPECT_EQ(seen.raw, JunctionCode::straight);
  }
}

TEST_F(Perception, ADeadEndEndsTheLineAndIsNoJunction) {
  const Pose pose{.x_m = -0.1, .y_m = 0.02, .heading_rad = -0.04};
  const StripeFeatures& seen = see(node_floor({kBehind}, kTape_m), pose);
  ASSERT_EQ(seen.lines.size(), 1u);
  EXPECT_FALSE(seen.junction);
  EXPECT_TRUE(seen.line_ends_ahead);
  EXPECT_EQ(seen.raw, JunctionCode::straight);
  EXPECT_NEAR(seen.lines[0].end.y, -(0.1 + 0.025) / 0.5, 0.03);
}

TEST_F(Perception, OfTwoParallelsThePriorDecides) {
  const Pose pose{.height_m = 0.6};
  Floor floor = straight_floor(kTape_m);
  floor.strips = {{{-5.0, 0.15}, {5.0, 0.15}, kTape_m}, {{-5.0, -0.2}, {5.0, -0.2}, kTape_m}};
  const TestMask mask = draw(geometry_, pose, floor);
  const double left = -0.15 / 0.6, right = 0.2 / 0.6;
  ASSERT_EQ(see(mask, pose).lines.size(), 2u);
  EXPECT_NEAR(see(mask, pose).lines[0].rho, left, 3e-3);  // the nearer one
  EXPECT_NEAR(see(mask, pose, StripePrior{.rho = 0.3}).lines[0].rho, right, 3e-3);
  EXPECT_NEAR(see(mask, pose, StripePrior{.rho = -0.3, .theta_rad = kPi}).lines[0].rho, right, 3e-3);
  EXPECT_FALSE(see(mask, pose).junction);
}

TEST_F(Perception, OneBorderInViewTakesTheWidthFromTheHint) {
  const Pose pose{.y_m = 0.4, .height_m = 0.5};  // the right-hand border of the stripe is out of view
  const TestMask mask = draw(geometry_, pose, straight_floor(kBroad_m));
  const double truth = 0.4 / 0.5;
  const StripePrior hint{.rho = 0.7, .theta_rad = 0.0, .width = kBroad_m / 0.5};
  ASSERT_EQ(see(mask, pose, hint).lines.size(), 1u);
  const LineFeature hinted = see(mask, pose, hint).lines[0];
  EXPECT_NEAR(hinted.rho, truth, 3e-3);
  ASSERT_EQ(see(mask, pose).lines.size(), 1u);
  const LineFeature guessed = see(mask, pose).lines[0];
  EXPECT_LT(guessed.quality, 0.5 * hinted.quality);
  EXPECT_LT(std::abs(guessed.rho - truth), 2.0 * std::sqrt(guessed.covariance(0, 0)));
}

TEST_F(Perception, WornRaggedAndDirtyPaintStillGivesTheLineAndNoJunction) {
  for (const double width : {kBroad_m, kTape_m}) {
    TestRandom random(9);
    for (int k = 0; k < 25; ++k) {
      const Pose pose{.y_m = random.uniform(-0.1, 0.1),
                      .heading_rad = random.uniform(-0.15, 0.15),
                      .roll_rad = random.uniform(-0.07, 0.07),
                      .pitch_rad = random.uniform(-0.07, 0.07)};
      Floor floor = straight_floor(width);
      floor.strips = {{{-5.0, 0.0}, {0.05, 0.0}, width}, {{0.15, 0.0}, {5.0, 0.0}, width}};  // a gap of 0.1 m
      TestMask mask = draw(geometry_, pose, floor);
      blot(mask, random, 0.25, 16.0, false);
      blot(mask, random, 0.02, 6.0, true);
      test::add_noise(mask, random, 0.005);
      const StripeFeatures& seen = see(mask, pose);
      ASSERT_FALSE(seen.lines.empty()) << width << " " << k;
      const Eigen::Vector2d error = test::course_error(seen.lines[0].rho, seen.lines[0].theta_rad,
                                                       true_course(pose, {0.0, 0.0}, 0.0, width));
      EXPECT_NEAR(error.x(), 0.0, 4e-3);
      EXPECT_NEAR(error.y(), 0.0, radians(0.5));
      EXPECT_EQ(seen.raw, JunctionCode::straight);
    }
  }
}

// Dirt on a start disc, in line with a border of the line that leaves it, stretches that border across the
// disc, where there is paint on both sides of it.
TEST_F(Perception, ALineIsSeenToLeaveADirtyDisc) {
  const Pose pose{.x_m = 0.25};
  Floor floor = straight_floor(kTape_m);
  floor.strips = {{{0.0, 0.0}, {5.0, 0.0}, kTape_m}};
  const double radius_m = 0.15;
  for (double off_m = -0.6 * kTape_m; off_m <= 0.6 * kTape_m; off_m += 0.05 * kTape_m) {
    TestMask mask = draw(geometry_, pose, floor);
    test::for_each_pixel(geometry_, pose, [&](int x, int y, const Eigen::Vector2d& p) {
      const bool is_dirt = (p - Eigen::Vector2d(-0.09, off_m)).norm() < 0.014;
      if (p.norm() < radius_m) mask.set(x, y, !is_dirt);
    });
    const StripeFeatures& seen = see(mask, pose);
    ASSERT_FALSE(seen.lines.empty()) << off_m;
    const Eigen::Vector2d error = test::course_error(seen.lines[0].rho, seen.lines[0].theta_rad,
                                                     true_course(pose, {0.0, 0.0}, 0.0, kTape_m));
    EXPECT_NEAR(error.x(), 0.0, 4e-3) << off_m;
    EXPECT_NEAR(error.y(), 0.0, radians(0.5)) << off_m;
  }
}

// The next edge of a bend of half a right angle lies beside the one that ends: whole paint is no square arm.
TEST_F(Perception, ABendIsSeenWhereItIsOrNotAtAll) {
  for (const double turn_rad : {0.5 * kLeft, 0.5 * kRight})
    for (double ahead_m = 0.05; ahead_m <= 0.4; ahead_m += 0.005) {
      const Pose pose{.x_m = -ahead_m, .y_m = -0.005};
      const TestMask mask = draw(geometry_, pose, node_floor({kBehind, turn_rad}, kBroad_m));
      const StripeFeatures& seen = see(mask, pose);
      if (!seen.junction) continue;
      const Eigen::Vector2d off = seen.junction->centre.vector() - pose.level({0.0, 0.0});
      EXPECT_LT(off.norm(), 0.1) << turn_rad << ' ' << ahead_m;
    }
}

// Worn by a quarter, in blotches of up to a sixth of the width, with little left of many a border: the arms
// are told by their area, and nothing ends where it goes on.
TEST_F(Perception, WornBroadNodesKeepTheirArms) {
  const std::vector<std::vector<double>> nodes = {
      {kAhead, kBehind, kLeft, kRight}, {kAhead, kBehind, kLeft}, {kAhead, kBehind, kRight}};
  TestRandom random(5);
  int clear = 0, right = 0, ended = 0;
  for (const auto& arms : nodes) {
    const Floor floor = node_floor(arms, kBroad_m);
    for (int k = 0; k < 150; ++k) {
      const Pose pose{.x_m = random.uniform(-0.4, 0.4),
                      .y_m = random.uniform(-0.03, 0.03),
                      .heading_rad = random.uniform(-0.05, 0.05)};
      TestMask mask = draw(geometry_, pose, floor);
      blot(mask, random, 0.25, 12.0, false);
      const StripeFeatures& seen = see(mask, pose);
      const test::CodeTruth truth = test::true_code(geometry_, pose, floor);
      if (truth.margin_px < 4.0) continue;
      ++clear;
      right += int{seen.raw == truth.code};
      ended += int{seen.line_ends_ahead};
    }
  }
  EXPECT_GT(clear, 300);
  EXPECT_GE(right, 0.97 * clear);
  EXPECT_LE(ended, 0.01 * clear);
}

TEST_F(Perception, AnArcGivesItsLocalTangentOnce) {
  // Radius 1.5 m, the vehicle on the arc and along it: the tangent at the vehicle is ρ = 0, θ = 0.
  const Pose pose{};
  Floor arc;
  for (int k = -40; k < 40; ++k) {
    const auto at = [](double a) { return Eigen::Vector2d(1.5 * std::sin(a), 1.5 - 1.5 * std::cos(a)); };
    arc.strips.push_back({at(0.01 * k), at(0.01 * (k + 1) + 0.002), kTape_m});
  }
  const StripeFeatures& seen = see(arc, pose);
  ASSERT_FALSE(seen.lines.empty());
  EXPECT_LE(seen.lines.size(), 2u);
  EXPECT_NEAR(seen.lines[0].theta_rad, 0.0, radians(12.0));
  EXPECT_NEAR(seen.lines[0].rho, 0.0, 0.1);
  EXPECT_FALSE(seen.junction);
}

TEST_F(Perception, ALineThatBendsAwayDoesNotEnd) {
  for (double start_m = 0.0; start_m < 0.3; start_m += 0.02) {
    Floor bend;  // straight ahead, then an arc of radius 1.5 m to the left over 45°
    bend.strips.push_back({{-1.0, 0.0}, {start_m, 0.0}, 0.1});
    const auto at = [=](double a) {
      return Eigen::Vector2d(start_m + 1.5 * std::sin(a), 1.5 - 1.5 * std::cos(a));
    };
    for (int k = 0; k < 78; ++k) bend.strips.push_back({at(0.01 * k), at(0.01 * (k + 1) + 0.002), 0.1});
    EXPECT_FALSE(see(bend, Pose{}).line_ends_ahead) << start_m;
  }
}

TEST_F(Perception, NothingIsFoundWhereThereIsNoLine) {
  const Pose pose{};
  TestMask empty(test::kMaskSize, test::kMaskSize), full = empty, noise = empty, disc = empty;
  TestRandom random(5);
  test::add_noise(full, random, 2.0);
  test::add_noise(noise, random, 0.5);
  for (int y = 0; y < test::kMaskSize; ++y)
    for (int x = 0; x < test::kMaskSize; ++x)
      disc.set(x, y, std::hypot(0.005 * (x - 180), 0.00375 * (y - 220)) < 0.36);
  for (const TestMask* mask : {&empty, &full, &noise, &disc}) {
    const StripeFeatures& seen = see(*mask, pose);
    EXPECT_TRUE(seen.lines.empty());
    EXPECT_FALSE(seen.junction);
    EXPECT_EQ(seen.raw, JunctionCode::unrecognised);
    EXPECT_FALSE(seen.line_ends_ahead);
  }
}

TEST_F(Perception, TheSameMaskGivesTheSameAnswerWhateverCameBefore) {
  const Pose pose{.x_m = -0.1, .y_m = 0.03, .heading_rad = 0.06};
  const TestMask mask = draw(geometry_, pose, node_floor({kAhead, kBehind, kLeft}, kBroad_m));
  const StripeFeatures first = see(mask, pose);
  see(straight_floor(kTape_m), {});
  const StripeFeatures& again = see(mask, pose);
  ASSERT_EQ(again.lines.size(), first.lines.size());
  EXPECT_EQ(again.lines[0].rho, first.lines[0].rho);
  EXPECT_EQ(again.junction->centre.x, first.junction->centre.x);
  EXPECT_EQ(again.raw, first.raw);
}

TEST_F(Perception, RefusesMasksOfAnotherSizeAndBadOptions) {
  const TestMask small(64, 64);
  EXPECT_THROW(perception_.observe(small.view(), LevelView{}), std::invalid_argument);
  EXPECT_THROW(StripePerception(geometry_, {.stripe = {.max_stripes = 0}}), std::invalid_argument);
  EXPECT_THROW(StripePerception(geometry_, {.stripe = {.min_width = 2.0}}), std::invalid_argument);
  EXPECT_THROW(StripePerception(geometry_, {.junction = {.min_painted = 1.5}}), std::invalid_argument);
  EXPECT_THROW(StripePerception(geometry_, {.certain_end = -1.0}), std::invalid_argument);
}

}  // namespace
}  // namespace lineservo::features
