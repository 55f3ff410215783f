#include "apps/report/json_columns.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace lineservo::apps {
namespace {

std::string written(double value, int decimals) {
  std::string json;
  append_number(json, value, decimals);
  return json;
}

TEST(JsonColumns, ANumberHasNoTrailingZeros) {
  EXPECT_EQ(written(1.25, 6), "1.25");
  EXPECT_EQ(written(100.0, 6), "100");
  EXPECT_EQ(written(100.0, 0), "100");
  EXPECT_EQ(written(-0.5, 6), "-0.5");
  EXPECT_EQ(written(1.0 / 3.0, 4), "0.3333");
}

TEST(JsonColumns, ThereIsNoNegativeZero) {
  EXPECT_EQ(written(-1e-9, 6), "0");
  EXPECT_EQ(written(-0.0, 0), "0");
}

TEST(JsonColumns, WhatIsNoNumberIsNull) {
  EXPECT_EQ(written(std::numeric_limits<double>::quiet_NaN(), 6), "null");
  EXPECT_EQ(written(-std::numeric_limits<double>::infinity(), 6), "null");
}

TEST(JsonColumns, AColumnHasAValueARow) {
  std::string json;
  append_column(json, "half", std::vector<int>{1, 2, 3}, 1, [](int row) { return row / 2.0; });
  EXPECT_EQ(json, "\"half\":[0.5,1,1.5]");
  json.clear();
  append_column(json, "none", std::vector<int>{}, 1, [](int row) { return row / 2.0; });
  EXPECT_EQ(json, "\"none\":[]");
}

}  // namespace
}  // namespace lineservo::apps
