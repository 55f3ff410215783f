#include "vehicle/grabber/sequence_pattern.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/vehicle/grabber/source_files.h"

namespace lineservo::vehicle {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(SequencePattern, RefusesWhatAPrintfWouldTakeOtherwise) {
  for (const char* const bad : {"a.png", "a%s.png", "a%n.png", "a%d%d.png", "a%d%s.png", "a%%d.png",
                                "a%d%%.png", "a%*d.png", "a%-4d.png", "a%.4d.png", "a%4d.png", "a%00d.png",
                                "a%012d.png", "a%", "a%04", "a%04ld.png", "a%dir/b.png", "a%d/b.png"})
    EXPECT_THAT(test::complaint([&] { SequencePattern{bad}; }), HasSubstr("must have one %d")) << bad;
  EXPECT_THAT(test::complaint([] { SequencePattern{std::string(5000, 'a') + "%d"}; }),
              HasSubstr("must have one %d"));
}

TEST(SequencePattern, PrintsALong) {
  EXPECT_EQ(SequencePattern("x/f%04d.png").for_long(), "x/f%04ld.png");
  EXPECT_EQ(SequencePattern("f%d").for_long(), "f%ld");
}

TEST(SequencePattern, ListsTheNumbersThatItPrints) {
  const test::SourceFolder folder;
  for (const char* const name : {"f0010.png", "f0002.png", "f10000.png", "f03.png", "f0004.jpg", "g0005.png",
                                 "f000x.png", "f.png", "f00006.png"})
    folder.write(name, "");
  EXPECT_THAT(SequencePattern(folder.path("f%04d.png")).numbers(), ElementsAre(2, 10, 10000));
  EXPECT_THAT(SequencePattern(folder.path("f%d.png")).numbers(), ElementsAre(10000));
  EXPECT_TRUE(SequencePattern(folder.path("none/f%d.png")).numbers().empty());
}

}  // namespace
}  // namespace lineservo::vehicle
