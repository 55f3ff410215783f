#include "servo/executive/phase.h"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace lineservo::servo {
namespace {

using features::JunctionCode;
using Change = std::function<void(Situation&)>;

const PlanStep kCross{
    {JunctionCode::tee_ahead, JunctionCode::cross, false}, Manoeuvre::go_straight, 0.0, 5.0, "n"};
const PlanStep kTurn{
    {JunctionCode::corner_left, JunctionCode::tee_left, false}, Manoeuvre::turn, 1.57, 5.0, "t"};
const PlanStep kHover{{JunctionCode::tee_ahead, JunctionCode::cross, false}, Manoeuvre::hover, 0.0, 5.0, "h"};
constexpr NodeSighting kSeenCross{JunctionCode::cross, false};
constexpr NodeSighting kSeenTee{JunctionCode::tee_left, false};

/// A flight in which all is well: at height, on the line, halfway to the next node.
Situation all_is_well() {
  Situation s;
  s.phase_s = 1.0;
  s.height_m = 0.5;
  s.line_angle_rad = 0.0;
  s.line_offset_m = 0.0;
  s.travelled_m = 4.0;
  s.step = &kCross;
  s.node_distance_m = 0.1;
  s.servos_on_node = true;
  return s;
}

/// One condition and the situations in which it holds or not.
struct Row {
  const char* what;
  bool holds;
  Change change;
};

void expect_rows(bool (*predicate)(const Situation&, const PhaseOptions&), const std::vector<Row>& rows) {
  for (const Row& row : rows) {
    Situation s = all_is_well();
    row.change(s);
    EXPECT_EQ(predicate(s, PhaseOptions{}), row.holds) << row.what;
  }
}

TEST(Predicate, AtHeight) {
  expect_rows(at_height, {{"as asked for", true, [](Situation& s) { s.height_m = 0.5; }},
                          {"a little low", true, [](Situation& s) { s.height_m = 0.471; }},
                          {"a little high", true, [](Situation& s) { s.height_m = 0.529; }},
                          {"too low", false, [](Situation& s) { s.height_m = 0.469; }},
                          {"too high", false, [](Situation& s) { s.height_m = 0.531; }}});
}

/// On the line, and no start marker in view.
Change without_marker(Change change) {
  return [change](Situation& s) {
    s.node_distance_m.reset();
    change(s);
  };
}

TEST(Predicate, Aligned) {
  expect_rows(aligned,
              {{"on the line", true, without_marker([](Situation&) {})},
               {"within the angle", true, without_marker([](Situation& s) { s.line_angle_rad = -0.025; })},
               {"beyond the angle", false, without_marker([](Situation& s) { s.line_angle_rad = -0.027; })},
               {"within the offset", true, without_marker([](Situation& s) { s.line_offset_m = -0.019; })},
               {"beyond the offset", false, without_marker([](Situation& s) { s.line_offset_m = -0.021; })},
               {"no angle", false, without_marker([](Situation& s) { s.line_angle_rad.reset(); })},
               {"no offset", false, without_marker([](Situation& s) { s.line_offset_m.reset(); })},
               {"above the marker, whatever the line's offset", true,
                [](Situation& s) { s.line_offset_m = 0.18, s.node_distance_m = 0.019; }},
               {"beside the marker", false, [](Situation& s) { s.node_distance_m = 0.021; }},
               {"ahead of the marker, on the line", true,
                [](Situation& s) { s.node_distance_m = 0.25, s.looks_ahead = true; }},
               {"ahead of the marker, beside the line", false,
                [](Situation& s) { s.node_distance_m = 0.25, s.line_offset_m = 0.021, s.looks_ahead = true; }},
               {"offset of a law that only turns", true,
                [](Situation& s) { s.line_offset_m = 0.1, s.servos_on_node = false; }},
               {"angle of a law that only turns", false,
                [](Situation& s) { s.line_angle_rad = 0.1, s.servos_on_node = false; }}});
}

TEST(Predicate, Docked) {
  const auto at = [](double distance_m, double speed_m_s) {
    return [=](Situation& s) { s.node_distance_m = distance_m, s.speed_m_s = speed_m_s; };
  };
  expect_rows(docked, {{"there and at rest", true, at(0.0, 0.0)},
                       {"within both bounds", true, at(0.014, 0.029)},
                       {"too far", false, at(0.016, 0.0)},
                       {"too fast", false, at(0.0, 0.031)},
                       {"no node", false, [](Situation& s) { s.node_distance_m.reset(); }}});
}

TEST(Predicate, Turned) {
  const auto left = [](double turn_left_rad) {
    return [=](Situation& s) { s.turn_left_rad = turn_left_rad; };
  };
  expect_rows(turned, {{"all of it", true, left(0.0)},
                       {"nearly", true, left(0.016)},
                       {"nearly, the other way", true, left(-0.016)},
                       {"not yet", false, left(0.018)},
                       {"too far", false, left(-0.018)},
                       {"by the gyro alone", false, [](Situation& s) { s.line_angle_rad.reset(); }},
                       {"by the gyro alone, for a law that does not dock", true,
                        [](Situation& s) { s.line_angle_rad.reset(), s.servos_on_node = false; }}});
}

TEST(Predicate, ExpectedMeansCodeAndLineEnd) {
  EXPECT_TRUE(expected(kSeenCross, kCross));
  EXPECT_FALSE(expected(kSeenTee, kCross));
  EXPECT_FALSE(expected({JunctionCode::cross, true}, kCross));
}

TEST(Predicate, OverdueAndTooEarlyAreTheLengthWithToleranceAndSlack) {
  // 5 m: overdue beyond 5·1.2 + 0.6 = 6.6 m, too early before 5·0.8 − 0.6 = 3.4 m.
  const auto at = [](double travelled_m) { return [=](Situation& s) { s.travelled_m = travelled_m; }; };
  const Change no_plan = [](Situation& s) { s.step = nullptr, s.travelled_m = 99.0; };
  expect_rows(overdue, {{"in time", false, at(6.59)}, {"late", true, at(6.61)}, {"no plan", false, no_plan}});
  expect_rows(too_early,
              {{"early", true, at(3.39)}, {"in time", false, at(3.41)}, {"no plan", false, no_plan}});
}

TEST(Predicate, DeadReckoningMayBeOffByItsDrift) {
  // After 50 s the odometer may say 50·0.03 = 1.5 m too much or too little.
  const auto at = [](double travelled_m) {
    return [=](Situation& s) { s.travelled_m = travelled_m, s.since_node_s = 50.0; };
  };
  expect_rows(overdue, {{"in time", false, at(8.09)}, {"late", true, at(8.11)}});
  expect_rows(too_early, {{"early", true, at(1.89)}, {"in time", false, at(1.91)}});
}

TEST(Predicate, EachPhaseHasItsGoal) {
  Situation s = all_is_well();
  s.node_distance_m = 0.0;
  for (const Phase phase : {Phase::take_off, Phase::align, Phase::dock, Phase::turn}) {
    EXPECT_TRUE(goal_holds(phase, s, {})) << name(phase);
  }
  for (const Phase phase : {Phase::follow, Phase::hover, Phase::land, Phase::aborted, Phase::finished}) {
    EXPECT_FALSE(goal_holds(phase, s, {})) << name(phase);
  }
  s.height_m = 0.0;
  EXPECT_FALSE(goal_holds(Phase::take_off, s, {}));
  s.turn_left_rad = 1.0;
  EXPECT_FALSE(goal_holds(Phase::turn, s, {}));
}

/// One arrow of the state machine.
struct Transition {
  const char* what;
  Phase from, to;
  Change change;
  AbortReason reason = AbortReason::none;
};

void expect_transitions(const std::vector<Transition>& table, const PhaseOptions& options = {}) {
  for (const Transition& t : table) {
    Situation s = all_is_well();
    t.change(s);
    EXPECT_EQ(name(next(t.from, s, options)), name(t.to)) << t.what;
    EXPECT_EQ(name(abort_reason(t.from, s, options)), name(t.reason)) << t.what;
  }
}

const Change kNothing = [](Situation&) {};
Change settled_for(double settled_s) {
  return [=](Situation& s) { s.settled_s = settled_s; };
}
Change after_s(double phase_s) {
  return [=](Situation& s) { s.phase_s = phase_s; };
}
Change unseen_for(double line_unseen_s) {
  return [=](Situation& s) { s.line_unseen_s = line_unseen_s; };
}
Change seen(const NodeSighting& node, const PlanStep& step, bool servos_on_node) {
  return [=, &step](Situation& s) { s.node = node, s.step = &step, s.servos_on_node = servos_on_node; };
}

TEST(Next, GoalsThatHaveSettledLeadOn) {
  expect_transitions({
      {"climbing", Phase::take_off, Phase::take_off, settled_for(0.29)},
      {"at height", Phase::take_off, Phase::align, settled_for(0.31)},
      {"aligning", Phase::align, Phase::align, settled_for(0.29)},
      {"aligned", Phase::align, Phase::follow, settled_for(0.31)},
      {"docking", Phase::dock, Phase::dock, settled_for(0.29)},
      {"docked at the target", Phase::dock, Phase::hover,
       [](Situation& s) { s.settled_s = 0.31, s.step = &kHover; }},
      {"docked to turn", Phase::dock, Phase::turn, [](Situation& s) { s.settled_s = 0.31, s.step = &kTurn; }},
      {"turning", Phase::turn, Phase::turn, settled_for(0.29)},
      {"turned", Phase::turn, Phase::follow, settled_for(0.31)},
  });
}

TEST(Next, ACornerEndsOnTheNextLineWithoutSettling) {
  const auto rounded = [](double left_rad, bool past, bool on_line) {
    return [=](Situation& s) {
      s.turn_left_rad = left_rad, s.past_corner = past;
      if (!on_line) s.line_angle_rad.reset();
    };
  };
  expect_transitions({
      {"round it", Phase::corner, Phase::follow, rounded(0.04, true, true)},
      {"not yet turned", Phase::corner, Phase::corner, rounded(0.06, true, true)},
      {"on the arc", Phase::corner, Phase::corner, rounded(0.04, false, true)},
      {"without the next line", Phase::corner, Phase::corner, rounded(0.04, true, false)},
      {"the node out of sight", Phase::corner, Phase::turn, [](Situation& s) { s.node_distance_m.reset(); }},
  });
}

TEST(Next, NodesLeadToTheirManoeuvre) {
  expect_transitions({
      {"no node", Phase::follow, Phase::follow, kNothing},
      {"straight over", Phase::follow, Phase::follow, seen(kSeenCross, kCross, true)},
      {"straight over, no docking", Phase::follow, Phase::follow, seen(kSeenCross, kCross, false)},
      {"turn", Phase::follow, Phase::dock, seen(kSeenTee, kTurn, true)},
      {"turn without a stop", Phase::follow, Phase::corner,
       [](Situation& s) { s.node = kSeenTee, s.step = &kTurn, s.servos_on_node = s.rounds_corner = true; }},
      {"turn, no docking", Phase::follow, Phase::turn, seen(kSeenTee, kTurn, false)},
      {"hover", Phase::follow, Phase::dock, seen(kSeenCross, kHover, true)},
      {"hover, no docking", Phase::follow, Phase::hover, seen(kSeenCross, kHover, false)},
  });
}

TEST(Next, TheEndOfTheMission) {
  const auto on_ground = [](Situation& s) { s.on_ground = true; };
  const std::vector<Transition> either = {
      {"hovering", Phase::hover, Phase::hover, after_s(7.9)},
      {"sinking", Phase::land, Phase::land, kNothing},
      {"down", Phase::land, Phase::finished, on_ground},
      {"waiting", Phase::aborted, Phase::aborted, after_s(2.9)},
      {"waited", Phase::aborted, Phase::land, after_s(3.1)},
      {"done", Phase::finished, Phase::finished, after_s(1000.0)},
  };
  expect_transitions(either);
  expect_transitions({{"hovered", Phase::hover, Phase::finished, after_s(8.1)}});
  PhaseOptions landing;
  landing.land = true;
  expect_transitions(either, landing);
  expect_transitions({{"hovered, to land", Phase::hover, Phase::land, after_s(8.1)}}, landing);
}

TEST(Next, WhatCannotGoOnAborts) {
  using enum AbortReason;
  const auto far = [](double travelled_m) { return [=](Situation& s) { s.travelled_m = travelled_m; }; };
  const auto puzzling_node = [](Situation& s) { s.node = kSeenCross, s.node_puzzles = true; };
  const auto and_may_search = [](const Change& change) {
    return [change](Situation& s) { change(s), s.may_search = true; };
  };
  const auto no_node = [](Situation& s) { s.node_distance_m.reset(); };
  expect_transitions({
      {"no climb", Phase::take_off, Phase::aborted, after_s(15.1), take_off_failed},
      {"slow climb", Phase::take_off, Phase::take_off, after_s(14.9)},
      {"no alignment", Phase::align, Phase::aborted, after_s(15.1), line_lost},
      {"line gone, aligning", Phase::align, Phase::aborted, unseen_for(1.1), line_lost},
      {"line gone, following", Phase::follow, Phase::aborted, unseen_for(1.1), line_lost},
      {"line gone, to be searched for", Phase::follow, Phase::search, and_may_search(unseen_for(1.1))},
      {"line found", Phase::search, Phase::follow, [](Situation& s) { s.settled_s = 0.4; }},
      {"line not found", Phase::search, Phase::aborted, [](Situation& s) { s.search_is_over = true; },
       line_lost},
      {"line gone for a moment", Phase::follow, Phase::follow, unseen_for(0.9)},
      {"line gone, climbing", Phase::take_off, Phase::take_off, unseen_for(5.0)},
      {"line gone, turning", Phase::turn, Phase::turn, unseen_for(5.0)},
      {"a node that nothing explains", Phase::follow, Phase::aborted, puzzling_node, node_unexpected},
      {"no height", Phase::dock, Phase::aborted, [](Situation& s) { s.height_age_s = 1.1; }, height_unknown},
      {"no velocity", Phase::turn, Phase::aborted, [](Situation& s) { s.velocity_age_s = 1.1; },
       velocity_unknown},
      {"no numbers", Phase::follow, Phase::aborted, [](Situation& s) { s.not_finite_s = 0.6; }, not_finite},
      {"no time left", Phase::hover, Phase::aborted, [](Situation& s) { s.flight_s = 3585.1; }, out_of_time},
      {"down by itself", Phase::follow, Phase::aborted, [](Situation& s) { s.on_ground = true; }, grounded},
      {"a branch", Phase::follow, Phase::aborted, [](Situation& s) { s.line_off_s = 1.1; }, line_turns_off},
      {"no way made", Phase::follow, Phase::aborted, [](Situation& s) { s.stuck_s = 20.1; }, stuck},
      {"no hovering without a height", Phase::aborted, Phase::land,
       [](Situation& s) { s.phase_s = 0.0, s.given_up = height_unknown; }},
      {"no code in time", Phase::follow, Phase::aborted, far(6.7), node_overdue},
      {"still in time", Phase::follow, Phase::follow, far(6.5)},
      {"the node is lost", Phase::dock, Phase::aborted, no_node, node_lost},
      {"docking for too long", Phase::dock, Phase::aborted, after_s(20.1), node_lost},
      {"turning for too long", Phase::turn, Phase::aborted, after_s(20.1), turn_failed},
      {"a corner that takes too long", Phase::corner, Phase::aborted, after_s(20.1), turn_failed},
      {"hovering for ever", Phase::aborted, Phase::land, after_s(100.0)},
  });
}

TEST(Names, AreThereForAll) {
  for (int k = 0; k <= static_cast<int>(Phase::search); ++k) EXPECT_NE(name(static_cast<Phase>(k)), "?");
  for (int k = 0; k <= static_cast<int>(AbortReason::grounded); ++k) {
    EXPECT_NE(name(static_cast<AbortReason>(k)), "?");
  }
}

/// A target of a mission, above which the vehicle hovers.
Situation above_target(const PlanStep& step, bool is_last) {
  Situation s = all_is_well();
  s.step = &step;
  s.is_last = is_last;
  s.settled_s = 1.0;
  return s;
}

PlanStep stop_at(const Stop& stop) {
  PlanStep step = kHover;
  step.stop = stop;
  return step;
}

TEST(Next, ATargetIsHoveredOverForAsLongAsItSays) {
  const PlanStep step = stop_at({.hover_s = 3.0});
  Situation s = above_target(step, false);
  s.phase_s = 2.9;
  EXPECT_EQ(next(Phase::hover, s, {}), Phase::hover);
  s.phase_s = 3.1;
  EXPECT_EQ(next(Phase::hover, s, {}), Phase::turn);
  s.is_last = true;
  EXPECT_EQ(next(Phase::hover, s, {}), Phase::finished);
}

TEST(Next, LookingGoesBeforeLandingAndLandingBeforeGoingOn) {
  const PlanStep step = stop_at({.hover_s = 3.0, .look = true, .land = true, .ground_s = 5.0});
  Situation s = above_target(step, false);
  s.phase_s = 4.0;
  EXPECT_EQ(next(Phase::hover, s, {}), Phase::look);
  EXPECT_EQ(next(Phase::look, s, {}), Phase::land);
  EXPECT_EQ(next(Phase::land, s, {}), Phase::land);
  s.on_ground = true;
  EXPECT_EQ(next(Phase::land, s, {}), Phase::rest);
  EXPECT_EQ(next(Phase::rest, s, {}), Phase::rest);
  s.phase_s = 5.1;
  EXPECT_EQ(next(Phase::rest, s, {}), Phase::relaunch);
  EXPECT_EQ(next(Phase::relaunch, s, {}), Phase::turn);
  s.is_last = true;
  EXPECT_EQ(next(Phase::land, s, {}), Phase::finished);
}

TEST(Next, AFlightThatWasBrokenOffStaysOnTheGround) {
  const PlanStep step = stop_at({});
  Situation s = above_target(step, false);
  s.on_ground = s.gave_up = true;
  EXPECT_EQ(next(Phase::land, s, {}), Phase::finished);
}

TEST(Next, ARelaunchThatDoesNotSucceedIsBrokenOff) {
  const PlanStep step = stop_at({.land = true});
  Situation s = above_target(step, false);
  s.phase_s = 36.0;
  EXPECT_EQ(abort_reason(Phase::relaunch, s, {}), AbortReason::node_lost);
  s.height_m = 0.1;
  EXPECT_EQ(abort_reason(Phase::relaunch, s, {}), AbortReason::take_off_failed);
  EXPECT_EQ(next(Phase::relaunch, s, {}), Phase::aborted);
}

}  // namespace
}  // namespace lineservo::servo
