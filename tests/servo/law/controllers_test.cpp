#include "servo/law/controllers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <stdexcept>

namespace lineservo::servo {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

TEST(Controllers, EachHasANameOfItsOwnAndMakesALaw) {
  std::set<std::string_view> names;
  for (const Controller& controller : controllers()) {
    EXPECT_TRUE(names.insert(controller.name).second) << controller.name;
    EXPECT_FALSE(controller.summary.empty());
    EXPECT_FALSE(controller.junction_method.empty());
    EXPECT_NE(controller.make(LawOptions{}), nullptr);
    EXPECT_EQ(&find_controller(controller.name), &controller);
  }
}

TEST(Controllers, OursDocksAndThePublishedOneStopsOnTheCode) {
  EXPECT_TRUE(find_controller("ibvs").traits.servos_on_node);
  EXPECT_FALSE(find_controller("pid").traits.servos_on_node);
  EXPECT_EQ(find_controller("pid").junction_method, "fpd");
  for (const char* name : {"grid", "lfpf", "carrot", "improved-carrot"}) {
    EXPECT_FALSE(find_controller(name).traits.servos_on_node) << name;
    EXPECT_TRUE(find_controller(name).traits.steers_heading) << name;
    EXPECT_FALSE(find_controller(name).adaptations.empty()) << name;
  }
}

TEST(Controllers, SeeWhatTheirPapersSaw) {
  EXPECT_EQ(find_controller("lfpf").needs.line_method, "fitline");
  EXPECT_FALSE(find_controller("lfpf").needs.tilt_corrected);
  EXPECT_TRUE(find_controller("carrot").needs.boundary_centres);
  EXPECT_TRUE(find_controller("grid").needs.tilt_corrected);
}

TEST(Controllers, OnlyTheVisualServoLawsDock) {
  for (const Controller& controller : controllers())
    EXPECT_EQ(controller.traits.servos_on_node, controller.name.starts_with("ibvs")) << controller.name;
}

TEST(Controllers, WhatFliesOnTheTargetPointAsksForIt) {
  EXPECT_TRUE(find_controller("vtp").needs.target_point);
  EXPECT_FALSE(find_controller("vtp").needs.tilt_corrected);  // its paper does not correct for tilt
  EXPECT_TRUE(find_controller("ibvs-point").needs.target_point);
  EXPECT_TRUE(find_controller("ibvs-point").needs.tilt_corrected);
  EXPECT_FALSE(find_controller("ibvs-centroid").needs.target_point);
  EXPECT_NEAR(find_controller("vtp").published_speed_m_s, 0.5225, 1e-12);
}

TEST(Controllers, AnUnknownNameIsAnsweredWithThoseThatThereAre) {
  try {
    find_controller("lqr");
    FAIL() << "no exception";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("'lqr'"), HasSubstr("ibvs"), HasSubstr("pid")));
  }
  EXPECT_THROW(find_controller(""), std::invalid_argument);
  EXPECT_THROW(find_controller("IBVS"), std::invalid_argument);
}

Controller own(const std::string& name) {
  return {.name = name,
          .summary = "none of those that ship",
          .traits = {.servos_on_node = false},
          .make = [](const LawOptions& o) { return std::make_unique<PidLaw>(o.pid); }};
}

std::string refusal(const Controller& controller) {
  try {
    add_controller(controller);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(OwnControllers, StandBehindThoseThatShip) {
  const Controller& ibvs = find_controller("ibvs");
  Controller controller = own("own-1");
  controller.gains = {{.name = "kp", .value = 0.25, .low = 0.1, .high = 2.0}, {.name = "ki_per_s"}};
  add_controller(controller);

  EXPECT_EQ(&find_controller("ibvs"), &ibvs);  // where it was
  EXPECT_EQ(&find_controller("own-1"), &controllers().back());
  EXPECT_NE(controllers().back().make(LawOptions{}), nullptr);
  EXPECT_EQ(LawOptions{}.own_gain("own-1.kp"), 0.25);
  EXPECT_EQ(LawOptions{}.own_gain("own-1.ki_per_s"), 0.0);
  EXPECT_THROW(LawOptions{}.own_gain("own-1.kd"), std::out_of_range);
  EXPECT_EQ(refusal(controller), "controller 'own-1': its name is taken");
}

TEST(OwnControllers, NeedANameThatIsFreeAndPlain) {
  for (const char* taken : {"ibvs", "vtp", "dock"})
    EXPECT_THAT(refusal(own(taken)), AllOf(HasSubstr(taken), HasSubstr("taken")));
  for (const char* name : {"", "Mine", "a b", "a,b", "a.b", "a/b", "-a", "2nd", "a_b", "größer", "a\n"})
    EXPECT_THAT(refusal(own(name)), HasSubstr("lower-case letters")) << name;
}

TEST(OwnControllers, NeedALawAndMethodsThatThereAre) {
  Controller controller = own("own-2");
  controller.make = nullptr;
  EXPECT_THAT(refusal(controller), HasSubstr("makes no law"));
  controller = own("own-2");
  controller.junction_method = "auto";
  EXPECT_THAT(refusal(controller), HasSubstr("stripe or fpd"));
  controller = own("own-2");
  controller.needs.line_method = "hough";
  EXPECT_THAT(refusal(controller), AllOf(HasSubstr("'hough'"), HasSubstr("combined")));
}

TEST(OwnControllers, NeedGainsWithinTheirRanges) {
  const auto with = [](const std::vector<OwnGain>& gains) {
    Controller controller = own("own-3");
    controller.gains = gains;
    return refusal(controller);
  };
  EXPECT_THAT(with({{.name = "kp", .value = 3.0, .high = 2.0}}), HasSubstr("'kp' is not between"));
  EXPECT_THAT(with({{.name = "kp", .value = std::nan("")}}), HasSubstr("'kp' is not between"));
  EXPECT_THAT(with({{.name = "kp"}, {.name = "kp"}}), HasSubstr("two gains 'kp'"));
  for (const char* name : {"", "k p", "k.p", "_k", "k="})
    EXPECT_THAT(with({{.name = name}}), HasSubstr("not a plain name")) << name;
  EXPECT_THROW(find_controller("own-3"), std::invalid_argument);
}

}  // namespace
}  // namespace lineservo::servo
