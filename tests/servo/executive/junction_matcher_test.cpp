#include "servo/executive/junction_matcher.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

namespace lineservo::servo {
namespace {

using features::CodeReading;
using features::JunctionCode;

/// "J5" or, with the line seen to end ahead, "J5!".
CodeReading reading(const std::string& text) {
  CodeReading r;
  r.raw = r.held = r.smoothed = static_cast<JunctionCode>(text[1] - '0');
  r.line_ends_ahead = text.size() > 2;
  return r;
}

/// What is told of a sequence of frames, "J7*3" for three of them: the nodes in order, same spelling.
std::string told(const std::string& frames, int confirm_frames = 2) {
  JunctionMatcher matcher(confirm_frames);
  std::istringstream in(frames);
  std::string nodes, token;
  while (in >> token) {
    const std::size_t star = token.find('*');
    const int count = star == std::string::npos ? 1 : std::stoi(token.substr(star + 1));
    for (int k = 0; k < count; ++k) {
      const auto node = matcher.update(reading(token.substr(0, star)), true);
      if (!node) continue;
      nodes +=
          (nodes.empty() ? "" : " ") + std::string(features::name(node->code)) + (node->line_ends ? "!" : "");
    }
  }
  return nodes;
}

TEST(JunctionMatcher, PassingSequencesOfTheTable) {
  EXPECT_EQ(told("J2*3 J7*4 J3*5 J6*4 J2*5"), "J3");  // ┼
  EXPECT_EQ(told("J2*3 J5*4 J9*5 J5*4 J2*5"), "J9");  // ┤
  EXPECT_EQ(told("J2*3 J4*4 J8*5 J4*4 J2*5"), "J8");  // ├
  EXPECT_EQ(told("J2*3 J5*4 J5!*5 J1*2"), "J5!");     // ┐
  EXPECT_EQ(told("J2*3 J4*4 J4!*5 J1*2"), "J4!");     // ┌
  EXPECT_EQ(told("J2*3 J7*4 J7!*5"), "J7!");          // ┬ that is one
  EXPECT_EQ(told("J2*5 J2!*5"), "J2!");               // dead end
  EXPECT_EQ(told("J2*50"), "");                       // plain line
}

TEST(JunctionMatcher, OneEventANodeAndEveryNode) {
  EXPECT_EQ(told("J2*3 J7*4 J3*9 J6*4 J2*9 J7*4 J3*9 J6*4 J2*9 J5*3 J9*6 J5*3 J2"), "J3 J3 J9");
}

TEST(JunctionMatcher, AFlickerOfOneFrameIsNoNode) {
  EXPECT_EQ(told("J2*5 J3 J2*5 J9 J2*5 J5! J2*5"), "");
  EXPECT_EQ(told("J2*3 J7*4 J3 J7 J3*4 J6*4 J2*5"), "J3");    // nor does it hide one
  EXPECT_EQ(told("J2*3 J5*4 J9*2 J5 J9*3 J5*4 J2*5"), "J9");  // nor tell it twice
  EXPECT_EQ(told("J2*3 J7*4 J3*3 J9 J3*3 J6*4 J2*5"), "J3");  // nor make another of it
  EXPECT_EQ(told("J2*3 J7*4 J9 J3*4 J6*4 J2*5"), "J3");       // one arm seen a frame late
}

TEST(JunctionMatcher, ConfirmationCountsFramesThatReadTheSame) {
  EXPECT_EQ(told("J2 J3*2", 3), "");
  EXPECT_EQ(told("J2 J3*3", 3), "J3");
  EXPECT_EQ(told("J2 J3*2 J8 J3*2 J8", 3), "");
  EXPECT_EQ(told("J2 J3", 1), "J3");
}

TEST(JunctionMatcher, WhatIsInViewAtTheStartIsLeftBehind) {
  EXPECT_EQ(told("J3*5 J6*4 J2*3"), "");
  EXPECT_EQ(told("J5*9 J2*3 J7*3 J3*3"), "J3");
  EXPECT_EQ(told("J0*9 J4*3 J8*3 J2*2 J8*3"), "J8");  // the start marker, and the corner below it
}

TEST(JunctionMatcher, RestartBeginsANewLeg) {
  JunctionMatcher matcher(2);
  EXPECT_TRUE(matcher.leaving());
  matcher.update(reading("J2"), true);
  EXPECT_FALSE(matcher.leaving());
  matcher.restart();
  EXPECT_TRUE(matcher.leaving());
  for (int k = 0; k < 5; ++k) EXPECT_FALSE(matcher.update(reading("J3"), true).has_value());
  matcher.update(reading("J2"), true);
  EXPECT_FALSE(matcher.update(reading("J3"), true).has_value());
  EXPECT_TRUE(matcher.update(reading("J3"), true).has_value());
  EXPECT_TRUE(matcher.leaving());
}

TEST(CompleteNode, TellsPreviewsFromNodes) {
  for (const char* complete : {"J3", "J8", "J9", "J2!", "J4!", "J5!", "J7!"}) {
    const auto node = complete_node(reading(complete));
    ASSERT_TRUE(node.has_value()) << complete;
    EXPECT_EQ(node->code, reading(complete).smoothed);
    EXPECT_EQ(node->line_ends, reading(complete).line_ends_ahead);
  }
  for (const char* disc : {"J0", "J0!"}) {  // the line may seem to end under it
    EXPECT_EQ(complete_node(reading(disc)), (NodeSighting{JunctionCode::start, false})) << disc;
  }
  for (const char* preview : {"J1", "J2", "J4", "J5", "J6", "J7", "J1!", "J6!"}) {
    EXPECT_FALSE(complete_node(reading(preview)).has_value()) << preview;
  }
}

TEST(IsClear, OnPlainLineThatGoesOn) {
  EXPECT_TRUE(is_clear(reading("J2")));
  EXPECT_FALSE(is_clear(reading("J2!")));
  for (const char* other : {"J0", "J1", "J3", "J4", "J5", "J6", "J7", "J8", "J9"}) {
    EXPECT_FALSE(is_clear(reading(other))) << other;
  }
}

TEST(JunctionMatcher, ANodeLeftBehindIsNotToldAgainBeforeItCanBeOutOfView) {
  JunctionMatcher matcher(1);
  for (int k = 0; k < 5; ++k) matcher.update(reading("J2"), false);  // a gap in the readings of the old node
  EXPECT_FALSE(matcher.update(reading("J3"), false).has_value());
  EXPECT_TRUE(matcher.leaving());
  matcher.update(reading("J2"), true);
  EXPECT_FALSE(matcher.leaving());
  EXPECT_TRUE(matcher.update(reading("J3"), true).has_value());
}

TEST(JunctionMatcher, ABendIsToldAfterAsManyFramesAndBeforeTheCode) {
  JunctionMatcher matcher(2);
  matcher.update(reading("J2"), true);
  EXPECT_FALSE(matcher.update(reading("J2"), true, Bend::left).has_value());
  EXPECT_FALSE(matcher.update(reading("J2"), true, Bend::right).has_value());
  EXPECT_EQ(matcher.update(reading("J5"), true, Bend::right),
            (NodeSighting{JunctionCode::straight, false, Bend::right}));
}

}  // namespace
}  // namespace lineservo::servo
