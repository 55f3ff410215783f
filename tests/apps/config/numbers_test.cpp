#include "apps/config/numbers.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace lineservo::apps {
namespace {

TEST(ParseNumber, TakesTheWholeTextWithinBounds) {
  EXPECT_EQ(parse_number("12", 0, 12), 12);
  EXPECT_EQ(parse_number("-3", -3, 12), -3);
  EXPECT_EQ(parse_number("2.5e-1", 0.0, 1.0), 0.25);
  EXPECT_EQ(parse_number<std::uint64_t>("18446744073709551615", 0, UINT64_MAX), UINT64_MAX);
}

TEST(ParseNumber, RefusesEverythingElse) {
  for (const char* text : {"", " 1", "1 ", "1x", "x", "1.5", "13", "-1", "99999999999999999999", "0x1", "+1"})
    EXPECT_FALSE(parse_number(text, 0, 12).has_value()) << text;
  for (const char* text : {"", "nan", "inf", "-inf", "1.1", "1e999", "0.5s"})
    EXPECT_FALSE(parse_number(text, 0.0, 1.0).has_value()) << text;
  EXPECT_FALSE(parse_number<std::uint64_t>("-1", 0, UINT64_MAX).has_value());
}

}  // namespace
}  // namespace lineservo::apps
