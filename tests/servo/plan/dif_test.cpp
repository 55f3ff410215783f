#include "servo/plan/dif.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace lineservo::servo {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::string digits(char zone, int i, int j) {
  return zone + std::to_string(i) + std::to_string(j);
}

TEST(Dif, EveryInstructionOfZoneAIsRead) {
  for (int i = 0; i < 10; ++i) {
    for (int j = 0; j < 10; ++j) EXPECT_EQ(parse_dif(digits('a', i, j)), (Dif{'a', i, j}));
  }
}

TEST(Dif, ZonesBToDAreReadWithinTheirTable) {
  for (int j = 0; j < 4; ++j) EXPECT_EQ(parse_dif(digits('b', 0, j)), (Dif{'b', 0, j}));
  for (int j = 0; j < 8; ++j) EXPECT_EQ(parse_dif(digits('c', 0, j)), (Dif{'c', 0, j}));
  EXPECT_EQ(parse_dif("d00"), (Dif{'d', 0, 0}));
}

TEST(Dif, BeyondTenTheLongSpelling) {
  EXPECT_EQ(parse_dif("a:12:3"), (Dif{'a', 12, 3}));
  EXPECT_EQ(parse_dif("a:3:12"), (Dif{'a', 3, 12}));
  EXPECT_EQ(parse_dif("a:999:999"), (Dif{'a', 999, 999}));
  EXPECT_EQ(parse_dif("a:1:3"), parse_dif("a13"));
}

TEST(Dif, TheCanonicalSpellingIsReadBack) {
  EXPECT_EQ(to_string({'a', 1, 3}), "a13");
  EXPECT_EQ(to_string({'a', 12, 3}), "a:12:3");
  EXPECT_EQ(to_string({'a', 3, 12}), "a:3:12");
  EXPECT_EQ(to_string(parse_dif("a:1:3")), "a13");
  for (const Dif& dif : {Dif{'a', 9, 9}, Dif{'a', 10, 0}, Dif{'b', 0, 3}, Dif{'c', 0, 7}, Dif{'d', 0, 0}}) {
    EXPECT_EQ(parse_dif(to_string(dif)), dif);
  }
}

class DifRubbish : public ::testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Spellings, DifRubbish,
                         ::testing::Values("", "a", "a1", "a123", "13", "e00", "A13", "b10", "b04", "c08",
                                           "c10", "d01", "d10", "a-1", "a1-", "a+1", "a:12", "a:12:", "a::12",
                                           "a:1:2:3", "a:-1:3", "a:+1:3", "a:1000:0", "a:0:1000",
                                           "a:99999999999:0", "a: 1:3", "b:0:4", "e:1:1", ":1:1",
                                           "::::", " a13", "a13 ", "a 3", "a1\n", "a1x", "ax1", "1a3", "а13",
                                           "a１３", "a\xc2\xb9", "node:a13", "a1.3", "0x1"));

TEST_P(DifRubbish, IsRefusedWithWhatIsAllowed) {
  const std::string& text = GetParam();
  try {
    parse_dif(text);
    FAIL() << "'" << text << "' was taken";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("'" + text + "'"), HasSubstr("a13"), HasSubstr("a:12:3"),
                                    HasSubstr("b00 to b03"), HasSubstr("c00 to c07"), HasSubstr("d00")));
  }
}

TEST(Dif, AZeroByteIsRubbishToo) {
  EXPECT_THROW(parse_dif(std::string_view("a1\0", 3)), std::invalid_argument);
}

}  // namespace
}  // namespace lineservo::servo
