#include "features/junction/code_filter.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace lineservo::features {
namespace {

// One digit a frame in; the smoothed and the held codes out in the same form.
struct Codes {
  std::string held, smoothed;
};

Codes run(CodeFilter& filter, const std::string& raw) {
  Codes out;
  for (const char digit : raw) {
    const CodeReading reading = filter.update(static_cast<JunctionCode>(digit - '0'));
    EXPECT_EQ(name(reading.raw), std::string("J") + digit);
    out.held += name(reading.held)[1];
    out.smoothed += name(reading.smoothed)[1];
  }
  return out;
}

Codes run(int window, const std::string& raw) {
  CodeFilter filter(window);
  return run(filter, raw);
}

TEST(CodeFilter, AWindowOfOneOnlyHolds) {
  const Codes out = run(1, "2141183112");
  EXPECT_EQ(out.held, "2244483332");
  EXPECT_EQ(out.smoothed, out.held);
}

TEST(CodeFilter, TheModeOfFiveSwitchesOnTheThirdFrame) {
  EXPECT_EQ(run(5, "2222244444").smoothed, "2222222444");
}

TEST(CodeFilter, TheModeOfThreeSwitchesOnTheSecondAndOfNineOnTheFifth) {
  EXPECT_EQ(run(3, "22222444").smoothed, "22222244");
  EXPECT_EQ(run(9, "222222222444444").smoothed, "222222222222244");
}

TEST(CodeFilter, ASingleOutlierPasses) {
  EXPECT_EQ(run(5, "22222722222").smoothed, "22222222222");
}

TEST(CodeFilter, OfATieTheFirstInTheWindowWins) {
  EXPECT_EQ(run(5, "24").smoothed, "22");
  EXPECT_EQ(run(5, "2424").smoothed, "2222");
  EXPECT_EQ(run(5, "77448").smoothed, "77777");
  EXPECT_EQ(run(5, "774482").smoothed.back(), '4');  // the window is 74482
  EXPECT_EQ(run(3, "248").smoothed.back(), '2');
}

// J1 repeats the smoothed code, not the last raw one.
TEST(CodeFilter, HoldRepeatsTheSmoothedCode) {
  const Codes out = run(5, "222241");
  EXPECT_EQ(out.held, "222242");
  EXPECT_EQ(out.smoothed, "222222");
}

TEST(CodeFilter, NothingToHoldIsUnrecognised) {
  const Codes out = run(5, "1112");
  EXPECT_EQ(out.held, "1112");
  EXPECT_EQ(out.smoothed, "1111");
}

TEST(CodeFilter, ResetForgets) {
  CodeFilter filter(5);
  run(filter, "22222");
  filter.reset();
  EXPECT_EQ(run(filter, "14").held, "14");
}

TEST(CodeFilter, IsAValue) {
  CodeFilter filter(5);
  run(filter, "222");
  CodeFilter copy = filter;
  EXPECT_EQ(run(copy, "444").smoothed, "224");
  EXPECT_EQ(run(filter, "444").smoothed, "224");
}

TEST(CodeFilter, PassesTheLineEndOn) {
  CodeFilter filter;
  EXPECT_TRUE(filter.update(JunctionCode::corner_left, true).line_ends_ahead);
  EXPECT_FALSE(filter.update(JunctionCode::corner_left, false).line_ends_ahead);
}

TEST(CodeFilter, AFrameThatReadsOtherwiseSaysNothingOfTheLinesEnd) {
  CodeFilter filter(5);
  for (int k = 0; k < 5; ++k) filter.update(JunctionCode::corner_left);
  const CodeReading misread = filter.update(JunctionCode::straight, true);
  EXPECT_EQ(misread.smoothed, JunctionCode::corner_left);
  EXPECT_FALSE(misread.line_ends_ahead);
  EXPECT_TRUE(filter.update(JunctionCode::unrecognised, true).line_ends_ahead);  // held
}

TEST(CodeFilter, RefusesOtherWindows) {
  for (const int window : {-1, 0, 2, 4, 10, 11})
    EXPECT_THROW(CodeFilter{window}, std::invalid_argument) << window;
  for (const int window : {1, 3, 5, 7, 9}) EXPECT_NO_THROW(CodeFilter{window}) << window;
}

}  // namespace
}  // namespace lineservo::features
