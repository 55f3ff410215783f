#include "features/junction/fpd.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string>

#include "features/junction/code_filter.h"

namespace lineservo::features {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr int kSide = 400;

// ---- Densities ----

MaskProfile uniform_profile(int per_column, int per_row) {
  MaskProfile profile;
  profile.columns.assign(kSide, per_column);
  profile.rows.assign(kSide, per_row);
  profile.foreground = per_column * kSide;
  return profile;
}

TEST(PixelDensities, AreThousandthsOfEachBin) {
  MaskProfile profile = uniform_profile(0, 0);
  for (int x = 60; x < 75; ++x) profile.columns[static_cast<std::size_t>(x)] = 400;  // bin 6 and half of 7
  for (int y = 0; y < 10; ++y) profile.rows[static_cast<std::size_t>(y)] = 15;
  const PixelDensities densities = pixel_densities(profile);
  EXPECT_EQ(densities.columns[5], 0);
  EXPECT_EQ(densities.columns[6], 1000);
  EXPECT_EQ(densities.columns[7], 500);
  EXPECT_EQ(densities.columns[8], 0);
  EXPECT_EQ(densities.rows[0], 38);  // 37.5, to the even one
  EXPECT_EQ(densities.rows[1], 0);
}

// A pixel of a bin of 4000 is a quarter of a thousandth.
TEST(PixelDensities, RoundToThreeDecimalsHalvesToEven) {
  const auto rounded = [](int pixels) {
    MaskProfile profile = uniform_profile(0, 0);
    profile.columns[0] = pixels;
    return pixel_densities(profile).columns[0];
  };
  EXPECT_EQ(rounded(1), 0);
  EXPECT_EQ(rounded(2), 0);   // 0.5
  EXPECT_EQ(rounded(3), 1);   // 0.75
  EXPECT_EQ(rounded(5), 1);   // 1.25
  EXPECT_EQ(rounded(6), 2);   // 1.5
  EXPECT_EQ(rounded(10), 2);  // 2.5
}

TEST(PixelDensities, BinsOfAnySizeCoverEveryPixelOnce) {
  MaskProfile profile;
  profile.columns.assign(417, 55);
  profile.rows.assign(55, 417);
  const PixelDensities densities = pixel_densities(profile);
  for (const int d : densities.columns) EXPECT_EQ(d, 1000);
  for (const int d : densities.rows) EXPECT_EQ(d, 1000);
  profile.columns.resize(39);
  EXPECT_THROW(pixel_densities(profile), std::invalid_argument);
}

// ---- Clusters ----

std::vector<double> means(std::initializer_list<int> bins) {
  return cluster_means_permille(std::vector<int>(bins));
}

TEST(Clusters, ABinJoinsBelowTheGapAndNotAtIt) {
  EXPECT_THAT(means({100, 109}), ElementsAre(104.5));
  EXPECT_THAT(means({100, 110}), IsEmpty());
  EXPECT_THAT(means({109, 100}), ElementsAre(104.5));
  EXPECT_THAT(means({110, 100}), IsEmpty());
}

TEST(Clusters, NeedTwoBins) {
  EXPECT_THAT(means({500}), IsEmpty());
  EXPECT_THAT(means({500, 500}), ElementsAre(500.0));
  EXPECT_THAT(means({500, 700, 900, 900}), ElementsAre(900.0));
}

// The comparison is with the bin before, not with the cluster: a slow ramp is one cluster.
TEST(Clusters, ChainAlongASlowRamp) {
  EXPECT_THAT(means({100, 109, 118, 127}), ElementsAre(113.5));
}

TEST(Clusters, EmptyBinsAreNoCluster) {
  EXPECT_THAT(means({0, 0, 0, 0}), IsEmpty());
  EXPECT_THAT(means({0, 0, 480, 480, 0, 0}), ElementsAre(480.0));
}

// Empty bins part what they stand between ...
TEST(Clusters, EmptyBinsPartARun) {
  EXPECT_THAT(means({480, 480, 0, 480, 480}), ElementsAre(480.0, 480.0));
}

// ... but a faint bin chains through them, and leaves them behind: (4 + 6) / 2, not (4 + 0 + 6) / 3.
TEST(Clusters, EmptyBinsChainAndAreDroppedAfterwards) {
  EXPECT_THAT(means({4, 0, 6}), ElementsAre(5.0));
  EXPECT_THAT(means({0, 0, 8}), IsEmpty());  // one bin is left
}

// ---- Trends ----

Trend trend(std::initializer_list<double> means) {
  return trend_of(std::vector<double>(means));
}

TEST(Trends, CountTheSteps) {
  EXPECT_EQ(trend({}), Trend::none);
  EXPECT_EQ(trend({480}), Trend::constant);
  EXPECT_EQ(trend({480, 1000}), Trend::rising);
  EXPECT_EQ(trend({1000, 480}), Trend::falling);
  EXPECT_EQ(trend({480, 1000, 480}), Trend::rising_falling);
}

TEST(Trends, AnythingElseIsOther) {
  EXPECT_EQ(trend({1000, 480, 1000}), Trend::other);
  EXPECT_EQ(trend({100, 480, 1000}), Trend::other);
  EXPECT_EQ(trend({1000, 480, 100}), Trend::other);
  EXPECT_EQ(trend({100, 480, 100, 480}), Trend::other);
}

TEST(Trends, MeansCloserThanTheGapAreOneLevel) {
  EXPECT_EQ(trend({480, 480}), Trend::constant);
  EXPECT_EQ(trend({480, 489.9}), Trend::constant);
  EXPECT_EQ(trend({480, 490}), Trend::rising);
  EXPECT_EQ(trend({490, 480}), Trend::falling);
  EXPECT_EQ(trend({480, 481, 1000}), Trend::rising);
  EXPECT_EQ(trend({480, 1000, 1000, 480}), Trend::rising_falling);
}

// ---- Codes ----

TEST(Codes, FollowTheTableOfTrends) {
  using enum Trend;
  const std::array<Trend, 6> trends = {none, constant, rising, falling, rising_falling, other};
  // Rows of the table: columns none, −, ↗, ↘, ↗↘, other; in each the rows none, −, ↗, ↘, ↗↘, other.
  const std::array<std::string, 6> table = {"121111", "121111", "115591", "114481", "116731", "111111"};
  for (std::size_t c = 0; c < 6; ++c)
    for (std::size_t r = 0; r < 6; ++r)
      EXPECT_EQ(name(code_of(trends[c], trends[r])), std::string("J") + table[c][r]) << c << " " << r;
}

// ---- Ideal masks: stripes of 0.36 m, which are 144 px wide along x and 192 px along y ----

struct Junction {
  int x = 200, y = 200;  // of the node
  bool forward = false, back = false, left = false, right = false;
  int half_x = 72, half_y = 96;
};

PackedMask draw(const Junction& j) {
  cv::Mat image = cv::Mat::zeros(kSide, kSide, CV_8UC1);
  const auto fill = [&](int left, int top, int right, int bottom) {
    const cv::Rect inside =
        cv::Rect(cv::Point(left, top), cv::Point(right, bottom)) & cv::Rect(0, 0, kSide, kSide);
    if (!inside.empty()) image(inside).setTo(255);
  };
  fill(j.x - j.half_x, j.y - j.half_y, j.x + j.half_x, j.y + j.half_y);
  constexpr int kFar = 10000;
  if (j.forward) fill(j.x - j.half_x, -kFar, j.x + j.half_x, j.y);
  if (j.back) fill(j.x - j.half_x, j.y, j.x + j.half_x, kFar);
  if (j.left) fill(-kFar, j.y - j.half_y, j.x, j.y + j.half_y);
  if (j.right) fill(j.x, j.y - j.half_y, kFar, j.y + j.half_y);
  return PackedMask::from_mat(image);
}

DensityReading read(const Junction& j, int marker_pixels = 0) {
  return read_densities(pixel_densities(profile_of(draw(j))), marker_pixels);
}

struct IdealCase {
  const char* what;
  Junction junction;
  const char* code;
  bool line_ends_ahead;
};

class IdealJunctions : public testing::TestWithParam<IdealCase> {};

TEST_P(IdealJunctions, ReadTheirCode) {
  const DensityReading reading = read(GetParam().junction);
  EXPECT_EQ(name(reading.code), GetParam().code);
  EXPECT_EQ(reading.line_ends_ahead, GetParam().line_ends_ahead);
}

INSTANTIATE_TEST_SUITE_P(
    WideStripes, IdealJunctions,
    testing::Values(IdealCase{"straight", {200, 200, true, true, false, false}, "J2", false},
                    IdealCase{"cross", {200, 200, true, true, true, true}, "J3", false},
                    IdealCase{"corner right ahead", {200, 200, false, true, false, true}, "J4", true},
                    IdealCase{"corner right behind", {200, 200, true, false, false, true}, "J4", false},
                    IdealCase{"corner left ahead", {200, 200, false, true, true, false}, "J5", true},
                    IdealCase{"corner left behind", {200, 200, true, false, true, false}, "J5", false},
                    IdealCase{"tee behind", {200, 200, true, false, true, true}, "J6", false},
                    IdealCase{"tee ahead", {200, 200, false, true, true, true}, "J7", true},
                    IdealCase{"tee right", {200, 200, true, true, false, true}, "J8", false},
                    IdealCase{"tee left", {200, 200, true, true, true, false}, "J9", false}),
    [](const auto& case_info) {
      std::string what = case_info.param.what;
      std::replace(what.begin(), what.end(), ' ', '_');
      return what;
    });

// Tape of 50 mm is 20 px along x and 27 px along y.
TEST(ThinTape, ReadsTheSameCodesWhenItFillsItsBins) {
  Junction tee{200, 200, true, true, false, true, 10, 15};
  EXPECT_EQ(name(read(tee).code), "J8");
  tee.left = true;
  EXPECT_EQ(name(read(tee).code), "J3");
}

// Two half-covered columns are one cluster, one full between two half-covered none: J2 holds either way.
TEST(ThinTape, AStraightLineNeedsNoColumnCluster) {
  for (const int x : {195, 200, 203})
    EXPECT_EQ(name(read({x, 200, true, true, false, false, 10, 15}).code), "J2") << x;
}

// The held codes while the node passes, pixel by pixel, from above the image to below it, without
// repetitions. Raw ones hold a J1 wherever an arm shows less than two full bins.
std::string passing(Junction j) {
  CodeFilter hold(1);
  std::string codes;
  for (j.y = -120; j.y <= 520; ++j.y) {
    const char digit = name(hold.update(read(j).code).held)[1];
    if (codes.empty() || codes.back() != digit) codes += digit;
  }
  return codes;
}

TEST(Passing, ATeeToTheRightReads24842) {
  EXPECT_EQ(passing({200, 0, true, true, false, true}), "24842");
}
TEST(Passing, ATeeToTheLeftReads25952) {
  EXPECT_EQ(passing({200, 0, true, true, true, false}), "25952");
}
TEST(Passing, ACrossReads27362) {
  EXPECT_EQ(passing({200, 0, true, true, true, true}), "27362");
}

// ---- Start marker and empty frames ----

TEST(StartMarker, IsMoreThan350Pixels) {
  const Junction straight{200, 200, true, true, false, false};
  EXPECT_EQ(name(read(straight, 350).code), "J2");
  EXPECT_EQ(name(read(straight, 351).code), "J0");
}

TEST(EmptyFrame, IsUnrecognised) {
  const DensityReading reading = read_densities({}, 0);
  EXPECT_EQ(name(reading.code), "J1");
  EXPECT_FALSE(reading.line_ends_ahead);
}

TEST(LineEnd, NeedsTwoEmptyBinsAtTheTop) {
  PixelDensities densities;
  densities.rows.fill(360);
  EXPECT_FALSE(line_ends_ahead(densities));
  densities.rows[0] = 0;
  EXPECT_FALSE(line_ends_ahead(densities));
  densities.rows[1] = 0;
  EXPECT_TRUE(line_ends_ahead(densities));
  densities.rows[0] = 360;
  EXPECT_FALSE(line_ends_ahead(densities));
}

}  // namespace
}  // namespace lineservo::features
