#include "apps/compare/search.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace lineservo::apps {
namespace {

using Points = std::vector<std::vector<double>>;

Points points_of(int budget, const SearchBox& box) {
  Points points;
  search_minimum(box, budget, [&points](const std::vector<double>& x) {
    points.push_back(x);
    return std::pow(x[0] - 0.5, 2) + 4.0 * std::pow(x[1] + 0.25, 2);
  });
  return points;
}

const SearchBox kBox = {{0.0, 0.0}, {-1.0, -1.0}, {1.0, 1.0}};

TEST(SearchMinimum, BeginsAtTheStartAndKeepsToItsBudget) {
  for (const int budget : {1, 2, 10, 60}) {
    const Points points = points_of(budget, kBox);
    EXPECT_EQ(points.front(), kBox.start);
    EXPECT_LE(points.size(), static_cast<std::size_t>(budget));
  }
}

TEST(SearchMinimum, FindsTheBottomOfABowl) {
  double nearest = 1.0;
  for (const auto& x : points_of(80, kBox)) nearest = std::min(nearest, std::hypot(x[0] - 0.5, x[1] + 0.25));
  EXPECT_LT(nearest, 0.02);
}

TEST(SearchMinimum, StaysInTheBox) {
  const SearchBox box = {{0.0, 0.0}, {-0.1, -0.1}, {0.2, 0.1}};
  for (const auto& x : points_of(60, box)) {
    EXPECT_THAT(x[0], ::testing::AllOf(::testing::Ge(-0.1), ::testing::Le(0.2)));
    EXPECT_THAT(x[1], ::testing::AllOf(::testing::Ge(-0.1), ::testing::Le(0.1)));
  }
}

TEST(SearchMinimum, TakesNoChance) {
  EXPECT_EQ(points_of(40, kBox), points_of(40, kBox));
}

TEST(SearchMinimum, ThrowsOnWhatTheCostThrows) {
  const auto cost = [](const std::vector<double>& x) -> double {
    if (x[0] != 0.0) throw std::runtime_error("enough");
    return 1.0;
  };
  EXPECT_THROW(search_minimum(kBox, 40, cost), std::runtime_error);
}

}  // namespace
}  // namespace lineservo::apps
