#include "servo/law/controllers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

}  // namespace
}  // namespace lineservo::servo
