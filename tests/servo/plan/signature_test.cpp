#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "features/geometry/angles.h"
#include "servo/plan/plan.h"

namespace lineservo::servo {
namespace {

using features::JunctionCode;
using features::kPi;
using features::radians;

TEST(Signature, OfAllSetsOfArms) {
  // The code of the table of codes.md with all arms in view; the preview is the code without the forward arm.
  using enum JunctionCode;
  struct Row {
    const char* arms;
    NodeSignature expected;
  };
  const Row table[] = {{"B", {straight, straight, true}},         {"FB", {straight, straight, false}},
                       {"BL", {corner_left, corner_left, true}},  {"BR", {corner_right, corner_right, true}},
                       {"FBL", {corner_left, tee_left, false}},   {"FBR", {corner_right, tee_right, false}},
                       {"BLR", {tee_ahead, tee_ahead, true}},     {"FBLR", {tee_ahead, cross, false}},
                       {"F", {unrecognised, straight, false}},    {"FL", {straight, corner_left, false}},
                       {"FR", {straight, corner_right, false}},   {"FLR", {unrecognised, tee_behind, false}},
                       {"LR", {unrecognised, unrecognised, true}}};
  for (const Row& row : table) {
    std::vector<double> angles;
    for (const char arm : std::string(row.arms)) {
      angles.push_back(arm == 'F' ? 0.0 : arm == 'B' ? kPi : arm == 'L' ? kPi / 2 : -kPi / 2);
    }
    EXPECT_EQ(signature(angles), row.expected) << row.arms;
  }
}

TEST(Signature, ArmsMayBeOffBy25Degrees) {
  const NodeSignature tee = signature({radians(24.0), radians(-156.0), radians(66.0)});
  EXPECT_EQ(tee.code, JunctionCode::tee_left);
  EXPECT_EQ(signature({radians(-24.0), radians(156.0), radians(114.0)}), tee);
  for (const double side : {1.0, -1.0}) {
    EXPECT_EQ(signature({kPi, radians(side * 116.0)}).bend, Bend::fork);
    EXPECT_THROW(signature({kPi, radians(side * 154.0)}), std::invalid_argument);
  }
}

TEST(Signature, TwoArmsAtAnAngleAreABend) {
  for (const double off_deg : {26.0, 45.0, 64.0}) {
    EXPECT_EQ(signature({kPi, radians(off_deg)}).bend, Bend::left) << off_deg;
    EXPECT_EQ(signature({radians(-off_deg), kPi}).bend, Bend::right) << off_deg;
    if (off_deg >= 40.0) {
      EXPECT_EQ(signature({kPi, 0.0, radians(off_deg)}).bend, Bend::fork) << off_deg;
    } else {
      EXPECT_THROW(signature({kPi, 0.0, radians(off_deg)}), std::invalid_argument) << off_deg;
    }
  }
  EXPECT_EQ(signature({kPi, radians(24.0)}).bend, Bend::none);
}

}  // namespace
}  // namespace lineservo::servo
