#include "apps/report/flight_trace.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lineservo::apps {
namespace {

std::vector<TracePoint> points(const std::vector<double>& errors_m) {
  std::vector<TracePoint> list;
  for (const double error_m : errors_m) list.push_back({static_cast<double>(list.size()), 0, 0, error_m, 0});
  return list;
}

TEST(Thinned, FewPointsStayAsTheyAre) {
  EXPECT_EQ(thinned(points({1, 2, 3}), 3).size(), 3u);
  EXPECT_TRUE(thinned({}, 3).empty());
}

TEST(Thinned, OfEachStretchTheLargestErrorStays) {
  const auto kept = thinned(points({0.1, -0.3, 0.2, 0.0, 0.0, 0.4, 0.1}), 2);
  ASSERT_EQ(kept.size(), 2u);
  EXPECT_EQ(kept[0].error_m, -0.3);
  EXPECT_EQ(kept[1].error_m, 0.4);
  EXPECT_LT(kept[0].t_s, kept[1].t_s);
}

TEST(Thinned, AnErrorGoesBeforeNone) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(thinned(points({none, 0.0, none}), 1).front().error_m, 0.0);
  EXPECT_TRUE(std::isnan(thinned(points({none, none}), 1).front().error_m));
}

}  // namespace
}  // namespace lineservo::apps
