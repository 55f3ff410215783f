#include "apps/scoring/junction_truth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <string>

#include "features/geometry/angles.h"
#include "tests/apps/test_floors.h"

namespace lineservo::apps {
namespace {

using features::Arms;
using features::JunctionCode;
using features::kPi;
using features::radians;
using testing::straight_edge;

constexpr double kArm_m = 3.0;

/// A node at the origin with straight arms of 3 m in these directions.
vehicle::Layout star(const std::vector<double>& headings_deg, double width_m = 0.36) {
  vehicle::Layout layout;
  layout.nodes = {{"p", {0, 0}}};
  for (const double heading_deg : headings_deg) {
    const double h = radians(heading_deg);
    layout.nodes.push_back(
        {"q" + std::to_string(layout.nodes.size()), {kArm_m * std::cos(h), kArm_m * std::sin(h)}});
    layout.edges.push_back(straight_edge(layout, 0, layout.nodes.size() - 1, width_m));
  }
  return layout;
}

Eigen::Isometry3d pose(double x_m, double y_m, double heading_rad, double height_m = 0.5,
                       double roll_rad = 0.0, double pitch_rad = 0.0) {
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  X_WB.linear() = (Eigen::AngleAxisd(heading_rad, Eigen::Vector3d::UnitZ()) *
                   Eigen::AngleAxisd(pitch_rad, Eigen::Vector3d::UnitY()) *
                   Eigen::AngleAxisd(roll_rad, Eigen::Vector3d::UnitX()))
                      .toRotationMatrix();
  X_WB.translation() = Eigen::Vector3d(x_m, y_m, height_m);
  return X_WB;
}

CodeTruth truth(const vehicle::Layout& layout, const Eigen::Isometry3d& X_WB, double travel_m = 0.0) {
  return JunctionTruth(layout, features::CameraModel({})).at(X_WB, travel_m);
}

/// The code seen `before_m` short of the node at the origin, travelling along +x.
CodeTruth approaching(const vehicle::Layout& layout, double before_m) {
  return truth(layout, pose(-before_m, 0.0, 0.0));
}

/// The codes that can be told for sure, in order, as the node passes beneath.
std::string passing(const std::vector<double>& headings_deg) {
  const vehicle::Layout layout = star(headings_deg);
  std::string codes;
  for (double x_m = -1.0; x_m <= 1.0; x_m += 0.002) {
    const CodeTruth seen = approaching(layout, -x_m);
    EXPECT_TRUE(seen.scored);
    if (seen.ambiguous()) continue;
    const std::string code(features::name(seen.code));
    if (codes.size() < 2 || codes.substr(codes.size() - 2) != code)
      codes += (codes.empty() ? "" : " ") + code;
  }
  return codes;
}

TEST(JunctionTruth, ACrossReadsAsInThePaperWhileItPasses) {
  EXPECT_EQ(passing({0, 90, 180, 270}), "J2 J7 J3 J6 J2");
}

TEST(JunctionTruth, ATeeToTheRightReadsAsInThePaperWhileItPasses) {
  EXPECT_EQ(passing({0, 180, 270}), "J2 J4 J8 J4 J2");
}

TEST(JunctionTruth, ATeeToTheLeftIsItsMirror) {
  EXPECT_EQ(passing({0, 180, 90}), "J2 J5 J9 J5 J2");
}

// h = 0.5 m: the frame reaches (0.75 m / 2) ahead; the side arms are 0.36 m wide, and 20 of its 400 rows
// of 1.875 mm are 0.0375 m. So the side arms open when 0.0375 m of them are in view: 0.375 + 0.18 − 0.0375 m
// before the node; and the forward arm, which begins 0.18 m beyond the node: 0.375 − 0.18 − 0.0375 = 0.1575 m
// before it.
constexpr double kPreview_m = 0.375 + 0.18 - 0.0375;
constexpr double kOpens_m = 0.375 - 0.18 - 0.0375;
constexpr double kBand_m = 4.0 * 0.75 / 400.0;

TEST(JunctionTruth, ACrossOpensSixteenCentimetresBeforeTheNode) {
  const vehicle::Layout cross = star({0, 90, 180, 270});
  EXPECT_EQ(approaching(cross, kOpens_m + 1e-6).code, JunctionCode::tee_ahead);
  EXPECT_EQ(approaching(cross, kOpens_m - 1e-6).code, JunctionCode::cross);
  EXPECT_EQ(approaching(cross, -kOpens_m + 1e-6).code, JunctionCode::cross);
  EXPECT_EQ(approaching(cross, -kOpens_m - 1e-6).code, JunctionCode::tee_behind);
}

TEST(JunctionTruth, ItsSideArmsComeIntoViewHalfAMetreBefore) {
  const vehicle::Layout cross = star({0, 90, 180, 270});
  EXPECT_EQ(approaching(cross, kPreview_m + 1e-6).code, JunctionCode::straight);
  EXPECT_EQ(approaching(cross, kPreview_m - 1e-6).code, JunctionCode::tee_ahead);
}

TEST(JunctionTruth, BothCodesCountWithinFourPixelsOfTheLimitAndOneBeyond) {
  const vehicle::Layout cross = star({0, 90, 180, 270});
  for (const double side : {-1.0, 1.0}) {
    const CodeTruth inside = approaching(cross, kOpens_m + side * (kBand_m - 1e-6));
    EXPECT_TRUE(inside.accepts(JunctionCode::cross));
    EXPECT_TRUE(inside.accepts(JunctionCode::tee_ahead));
    EXPECT_EQ(inside.accepted.size(), 2u);
    EXPECT_FALSE(approaching(cross, kOpens_m + side * (kBand_m + 1e-6)).ambiguous());
  }
}

TEST(JunctionTruth, HalfTheTravelOfAFrameWidensTheBand) {
  const vehicle::Layout cross = star({0, 90, 180, 270});
  const double travel_m = 0.04;
  EXPECT_TRUE(truth(cross, pose(-(kOpens_m + 0.5 * travel_m - 1e-6), 0, 0), travel_m).ambiguous());
  EXPECT_FALSE(truth(cross, pose(-(kOpens_m + 0.5 * travel_m + 1e-6), 0, 0), travel_m).ambiguous());
}

TEST(JunctionTruth, TellsEveryKindOfNodeFromAbove) {
  const auto above = [](const std::vector<double>& headings_deg) {
    return approaching(star(headings_deg), 0.0).code;
  };
  EXPECT_EQ(above({0, 90, 180, 270}), JunctionCode::cross);
  EXPECT_EQ(above({90, 180, 270}), JunctionCode::tee_ahead);
  EXPECT_EQ(above({0, 90, 270}), JunctionCode::tee_behind);
  EXPECT_EQ(above({0, 180, 270}), JunctionCode::tee_right);
  EXPECT_EQ(above({0, 90, 180}), JunctionCode::tee_left);
  EXPECT_EQ(above({180, 270}), JunctionCode::corner_right);
  EXPECT_EQ(above({0, 270}), JunctionCode::corner_right);
  EXPECT_EQ(above({180, 90}), JunctionCode::corner_left);
  EXPECT_EQ(above({0, 90}), JunctionCode::corner_left);
  EXPECT_EQ(above({0, 180}), JunctionCode::straight);
  EXPECT_EQ(above({180}), JunctionCode::straight);
  EXPECT_EQ(above({90, 270}), JunctionCode::unrecognised);
}

TEST(JunctionTruth, IsInTheFrameOfTheVehicle) {
  const vehicle::Layout tee = star({0, 180, 270});
  EXPECT_EQ(truth(tee, pose(0, 0, 0)).code, JunctionCode::tee_right);
  EXPECT_EQ(truth(tee, pose(0, 0, kPi)).code, JunctionCode::tee_left);
  EXPECT_EQ(truth(tee, pose(0, 0, kPi / 2)).code, JunctionCode::tee_ahead);
  EXPECT_EQ(truth(tee, pose(0, 0, -kPi / 2)).code, JunctionCode::tee_behind);
}

TEST(JunctionTruth, ALineAloneIsStraightAndAnEmptyFloorIsNothing) {
  const vehicle::Layout line = star({0, 180});
  EXPECT_EQ(truth(line, pose(1.5, 0, 0)).code, JunctionCode::straight);
  EXPECT_EQ(truth(line, pose(1.5, 2.0, 0)).code, JunctionCode::unrecognised);
  EXPECT_TRUE(truth(line, pose(1.5, 2.0, 0)).scored);
}

TEST(JunctionTruth, ArmsBeyondTwentyFiveDegreesAreNotScored) {
  const vehicle::Layout cross = star({0, 90, 180, 270});
  EXPECT_TRUE(truth(cross, pose(0, 0, radians(24.9))).scored);
  EXPECT_FALSE(truth(cross, pose(0, 0, radians(25.1))).scored);
  EXPECT_FALSE(truth(star({180, 45}), pose(0, 0, 0)).scored);
}

TEST(JunctionTruth, ArcsAreNotScored) {
  vehicle::Layout floor = star({180});
  floor.nodes.push_back({"r", {2, 2}});
  vehicle::LayoutEdge arc;
  arc.from = 0;
  arc.to = 2;
  arc.centreline = vehicle::Curve::arc({0, 0}, {2, 2}, {0, 2}, true);
  floor.edges.push_back(arc);
  EXPECT_FALSE(truth(floor, pose(0, 0, 0)).scored);
}

TEST(JunctionTruth, OfTwoNodesTheOneNearerToTheImageCentreCounts) {
  vehicle::Layout floor;  // a ├ at the origin and a ┤ 0.6 m further on
  floor.nodes = {{"p", {0, 0}}, {"q", {0.6, 0}}, {"a", {-3, 0}},
                 {"b", {3, 0}}, {"c", {0, -3}},  {"d", {0.6, 3}}};
  for (const auto& [from, to] : {std::pair{2, 0}, {0, 1}, {1, 3}, {0, 4}, {1, 5}})
    floor.edges.push_back(
        straight_edge(floor, static_cast<std::size_t>(from), static_cast<std::size_t>(to), 0.05));
  EXPECT_EQ(truth(floor, pose(0.28, 0, 0)).code, JunctionCode::tee_right);
  EXPECT_EQ(truth(floor, pose(0.32, 0, 0)).code, JunctionCode::tee_left);
}

// A disc of 20 mm has (π 0.02²) / (1.0 · 0.75 / 400²) = 268 pixels; J0 needs more than 350.
vehicle::Layout with_disc(double radius_m) {
  vehicle::Layout floor = star({0, 90, 180});
  floor.start_markers = {{{0.0, 0.0}, radius_m, {40, 40, 220}}};
  return floor;
}
double radius_of_pixels(double pixels) {
  return std::sqrt(pixels * (1.0 / 400.0) * (0.75 / 400.0) / kPi);
}

TEST(JunctionTruth, TheStartDiscGoesBeforeEveryNode) {
  const CodeTruth seen = truth(with_disc(0.18), pose(0, 0, 0));
  EXPECT_EQ(seen.code, JunctionCode::start);
  EXPECT_FALSE(seen.ambiguous());
}

TEST(JunctionTruth, TheStartDiscOutOfViewIsNone) {
  EXPECT_EQ(truth(with_disc(0.18), pose(1.5, 0, 0)).code, JunctionCode::straight);
}

TEST(JunctionTruth, NearTheLimitOfTheDiscBothCodesCountAndTheNearerOneIsTheCode) {
  const CodeTruth above = truth(with_disc(radius_of_pixels(370)), pose(0, 0, 0));
  EXPECT_EQ(above.code, JunctionCode::start);
  EXPECT_TRUE(above.accepts(JunctionCode::start));
  EXPECT_TRUE(above.accepts(JunctionCode::tee_left));
  const CodeTruth below = truth(with_disc(radius_of_pixels(330)), pose(0, 0, 0));
  EXPECT_EQ(below.code, JunctionCode::tee_left);
  EXPECT_TRUE(below.accepts(JunctionCode::start));
  EXPECT_TRUE(below.accepts(JunctionCode::tee_left));
}

TEST(JunctionTruth, AFewRedPixelsAreNoStart) {
  const CodeTruth seen = truth(with_disc(radius_of_pixels(40)), pose(0, 0, 0));
  EXPECT_EQ(seen.code, JunctionCode::tee_left);
  EXPECT_FALSE(seen.ambiguous());
}

/// A second way to the truth: points strewn over an arm's rectangle are put through a pinhole written out
/// here, and what falls into the frame is measured.
class Oracle {
 public:
  explicit Oracle(const Eigen::Isometry3d& X_WB) : X_BW_(X_WB.inverse()) {}

  /// Extent in the 400×400 frame, along x and y, of what is in view of an arm from the origin.
  Eigen::Vector2d extent_px(double heading_rad, double width_m) const {
    constexpr int kAlong = 3000, kAcross = 120;
    Eigen::Vector2d low(1e9, 1e9), high(-1e9, -1e9);
    for (int i = 0; i <= kAlong; ++i) {
      const double s_m = 0.5 * width_m + (1.6 - 0.5 * width_m) * i / kAlong;
      for (int k = 0; k <= kAcross; ++k) {
        const double d_m = width_m * (static_cast<double>(k) / kAcross - 0.5);
        const std::optional<Eigen::Vector2d> px =
            pixel({s_m * std::cos(heading_rad) - d_m * std::sin(heading_rad),
                   s_m * std::sin(heading_rad) + d_m * std::cos(heading_rad), 0.0});
        if (!px) continue;
        low = low.cwiseMin(*px);
        high = high.cwiseMax(*px);
      }
    }
    return low.x() > high.x() ? Eigen::Vector2d(0, 0) : Eigen::Vector2d(high - low);
  }

 private:
  /// Right is −y_B, down is −x_B, depth is −z_B; 1 m wide and 0.75 m high at 0.5 m, 400 pixels each.
  std::optional<Eigen::Vector2d> pixel(const Eigen::Vector3d& p_W) const {
    const Eigen::Vector3d p_B = X_BW_ * p_W;
    if (p_B.z() > -1e-3) return std::nullopt;
    const Eigen::Vector2d px(200.0 + 200.0 * p_B.y() / p_B.z(),
                             200.0 + 200.0 * (4.0 / 3.0) * p_B.x() / p_B.z());
    if (px.minCoeff() < 0.0 || px.maxCoeff() > 400.0) return std::nullopt;
    return px;
  }

  Eigen::Isometry3d X_BW_;
};

JunctionCode oracle_code(const std::vector<double>& headings_deg, double width_m,
                         const Eigen::Isometry3d& X_WB, double heading_rad, bool& near_limit) {
  const Oracle oracle(X_WB);
  Arms arms;
  bool any_in_view = false;
  for (const double arm_deg : headings_deg) {
    const double seen_px = oracle.extent_px(radians(arm_deg), width_m).minCoeff();
    any_in_view |= seen_px > 0.0;
    near_limit |= std::abs(seen_px - 20.0) < 5.5;
    if (seen_px < 20.0) continue;
    const double ahead = std::cos(radians(arm_deg) - heading_rad),
                 left = std::sin(radians(arm_deg) - heading_rad);
    if (ahead > std::cos(radians(25.0))) arms.forward = true;
    if (ahead < -std::cos(radians(25.0))) arms.back = true;
    if (left > std::cos(radians(25.0))) arms.left = true;
    if (left < -std::cos(radians(25.0))) arms.right = true;
  }
  if (arms == Arms{}) return any_in_view ? JunctionCode::straight : JunctionCode::unrecognised;
  return code_of(arms);
}

TEST(JunctionTruth, AgreesWithPointsStrewnOverTheArms) {
  const std::vector<std::vector<double>> stars = {
      {0, 90, 180, 270}, {0, 180, 270}, {90, 180, 270}, {180, 270}};
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  int compared = 0;
  for (int k = 0; k < 60; ++k) {
    const std::vector<double>& arms = stars[static_cast<std::size_t>(k) % stars.size()];
    const double width_m = k % 3 == 0 ? 0.05 : 0.36;
    const double heading_rad = radians(20.0) * unit(random);
    const Eigen::Isometry3d X_WB =
        pose(0.45 * unit(random), 0.15 * unit(random), heading_rad, 0.5 + 0.05 * unit(random),
             radians(4.0) * unit(random), radians(4.0) * unit(random));
    bool near_limit = false;
    const JunctionCode expected = oracle_code(arms, width_m, X_WB, heading_rad, near_limit);
    if (near_limit) continue;
    ++compared;
    const CodeTruth seen = truth(star(arms, width_m), X_WB);
    EXPECT_EQ(seen.code, expected) << k;
    EXPECT_FALSE(seen.ambiguous()) << k;
  }
  EXPECT_GT(compared, 40);
}

}  // namespace
}  // namespace lineservo::apps
