#include "features/mask/line_color.h"

#include <gtest/gtest.h>

namespace lineservo::features {
namespace {

TEST(LineColor, NamesAreReadBack) {
  for (const LineColor color : kLineColors) EXPECT_EQ(line_color(name(color)), color);
  EXPECT_EQ(line_color("red"), LineColor::red);
  EXPECT_EQ(line_color("Red"), std::nullopt);
  EXPECT_EQ(line_color(""), std::nullopt);
}

}  // namespace
}  // namespace lineservo::features
