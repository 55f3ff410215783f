#include "apps/flight/mission.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/apps/test_files.h"

namespace lineservo::apps {
namespace {

using ::testing::AllOf;
using testing::complaint;
using ::testing::HasSubstr;

FlightRequest request_for_a13() {
  FlightRequest request;
  request.instruction = "a13";
  return request;
}

TEST(Prepare, ReadsTheFloorAndCompilesThePlan) {
  const Mission mission = prepare(request_for_a13());
  EXPECT_EQ(mission.floor.name, "warehouse");
  EXPECT_EQ(mission.plan.target, "n13");
  EXPECT_EQ(mission.request.instruction, "a13");
}

TEST(Prepare, RefusesWhatCannotBeFlown) {
  FlightRequest request = request_for_a13();
  request.controller = "lqr";
  EXPECT_THROW(prepare(request), std::invalid_argument);
  request = request_for_a13();
  request.instruction = "a99";
  EXPECT_THROW(prepare(request), std::invalid_argument);
  request = request_for_a13();
  request.instruction = "node:nope";
  EXPECT_THAT(complaint([&] { prepare(request); }),
              AllOf(HasSubstr("no node 'nope'"), HasSubstr("n00, "), HasSubstr("n13")));
  request = request_for_a13();
  request.layout = "hall";
  EXPECT_THAT(complaint([&] { prepare(request); }), HasSubstr("hall"));
  request.layout = "p\xff.yaml";
  EXPECT_THAT(complaint([&] { prepare(request); }), HasSubstr("UTF-8"));
}

FlightRequest request_for_the_red_track(const std::string& controller) {
  FlightRequest request;
  request.instruction = "node:end";
  request.layout = "minidrone";
  request.controller = controller;
  return request;
}

TEST(Prepare, AnEndMarkerIsThereToLandOn) {
  EXPECT_TRUE(prepare(request_for_the_red_track("ibvs")).request.land);
  EXPECT_FALSE(prepare(request_for_a13()).request.land);
}

TEST(Prepare, OnlyALawThatPursuesTheLineFliesItWithoutTurns) {
  EXPECT_EQ(prepare(request_for_the_red_track("vtp")).plan.steps.size(), 1u);
  EXPECT_EQ(prepare(request_for_the_red_track("pid")).plan.steps.size(), 5u);
  FlightRequest request = request_for_a13();
  request.controller = "vtp";
  EXPECT_EQ(prepare(request).plan.steps.size(), 4u);
}

}  // namespace
}  // namespace lineservo::apps
