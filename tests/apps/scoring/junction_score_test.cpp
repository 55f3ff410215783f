#include "apps/scoring/junction_score.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/apps/test_floors.h"

namespace lineservo::apps {
namespace {

using features::JunctionCode;
using servo::Phase;

class JunctionScoreTest : public ::testing::Test {
 protected:
  JunctionScoreTest() {
    floor_.nodes = {{"p", {0, 0}}, {"q", {6, 0}}};
    floor_.edges = {testing::straight_edge(floor_, 0, 1, 0.36)};
  }
  /// A frame of plain line, in which the recogniser reads these.
  TickRecord& tick(JunctionCode raw, JunctionCode held, JunctionCode smoothed) {
    TickRecord tick;
    tick.at_capture.p_WB = {3.0, 0.0, 0.5};
    tick.at_capture.phase = tick.now.phase = Phase::follow;
    tick.code = {raw, held, smoothed, false};
    record_.ticks.push_back(tick);
    return record_.ticks.back();
  }
  JunctionScore score() const {
    return score_junctions(record_, JunctionTruth(floor_, features::CameraModel({})), 0.1);
  }

  vehicle::Layout floor_;
  FlightRecord record_;
};

TEST_F(JunctionScoreTest, WithoutFramesThereIsNoAccuracy) {
  EXPECT_EQ(score().frames, 0);
  EXPECT_TRUE(std::isnan(score().accuracy(0)));
}

TEST_F(JunctionScoreTest, CountsRawHeldAndSmoothedCodesApart) {
  tick(JunctionCode::straight, JunctionCode::straight, JunctionCode::straight);
  tick(JunctionCode::unrecognised, JunctionCode::straight, JunctionCode::straight);
  tick(JunctionCode::cross, JunctionCode::cross, JunctionCode::straight);
  tick(JunctionCode::cross, JunctionCode::cross, JunctionCode::cross);
  const JunctionScore s = score();
  EXPECT_EQ(s.frames, 4);
  EXPECT_EQ(s.misclassified, 3);
  EXPECT_EQ(s.held_wrong, 2);
  EXPECT_EQ(s.smoothed_wrong, 1);
  EXPECT_DOUBLE_EQ(s.accuracy(s.misclassified), 0.25);
  EXPECT_EQ(s.ambiguous, 0);
}

TEST_F(JunctionScoreTest, TheConfusionIsByTrueAndRawCode) {
  tick(JunctionCode::straight, JunctionCode::straight, JunctionCode::straight);
  tick(JunctionCode::straight, JunctionCode::straight, JunctionCode::straight);
  tick(JunctionCode::tee_left, JunctionCode::straight, JunctionCode::straight);
  const JunctionScore s = score();
  EXPECT_EQ(s.confusion[2][2], 2);
  EXPECT_EQ(s.confusion[2][9], 1);
  long sum = 0;
  for (const auto& row : s.confusion)
    for (const long count : row) sum += count;
  EXPECT_EQ(sum, s.frames);
}

TEST_F(JunctionScoreTest, OnlyFramesTakenAndHandledInFollowAreScored) {
  for (const Phase phase :
       {Phase::take_off, Phase::align, Phase::turn, Phase::dock, Phase::hover, Phase::land}) {
    tick(JunctionCode::cross, JunctionCode::cross, JunctionCode::cross).at_capture.phase = phase;
    tick(JunctionCode::cross, JunctionCode::cross, JunctionCode::cross).now.phase = phase;
  }
  EXPECT_EQ(score().frames, 0);
}

TEST_F(JunctionScoreTest, ThePoseOfTheExposureCountsAndNotThatOfTheTick) {
  TickRecord& t = tick(JunctionCode::unrecognised, JunctionCode::unrecognised, JunctionCode::unrecognised);
  t.at_capture.p_WB.y() = 3.0;  // nothing in view
  EXPECT_EQ(score().misclassified, 0);
  EXPECT_EQ(score().confusion[1][1], 1);
}

TEST_F(JunctionScoreTest, TiltMovesTheView) {
  // A ┤ at (3, 0), 0.1 m before its forward arm opens; nose up by 0.3 rad the camera looks 0.15 m further
  // ahead.
  floor_.nodes = {{"p", {0, 0}}, {"q", {6, 0}}, {"c", {3, 0}}, {"r", {3, 3}}};
  floor_.edges.clear();
  for (const std::size_t end : {0, 1, 3})
    floor_.edges.push_back(testing::straight_edge(floor_, 2, end, 0.36));
  tick(JunctionCode::corner_left, JunctionCode::straight, JunctionCode::straight).at_capture.p_WB.x() =
      3.0 - 0.2575;
  TickRecord& tilted = tick(JunctionCode::tee_left, JunctionCode::straight, JunctionCode::straight);
  tilted.at_capture.p_WB.x() = 3.0 - 0.2575;
  tilted.at_capture.pitch_rad = -0.3;
  EXPECT_EQ(score().frames, 2);
  EXPECT_EQ(score().misclassified, 0);
  EXPECT_EQ(score().ambiguous, 0);
}

TEST_F(JunctionScoreTest, EventsAreTheNodesPassedAndTheOneThatWasNotRight) {
  record_.steps_done = 3;
  EXPECT_EQ(score().events, 3);
  EXPECT_EQ(score().events_right, 3);
  record_.abort_reason = servo::AbortReason::node_unexpected;
  EXPECT_EQ(score().events, 4);
  record_.abort_reason = servo::AbortReason::node_overdue;
  EXPECT_EQ(score().events, 4);
  record_.abort_reason = servo::AbortReason::line_lost;
  EXPECT_EQ(score().events, 3);
  EXPECT_EQ(score().events_right, 3);
}

}  // namespace
}  // namespace lineservo::apps
