#include "apps/evaluate/line_evaluation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "apps/evaluate/line_report.h"
#include "features/geometry/angles.h"

namespace lineservo::apps {
namespace {

using features::canonical_line;
using features::ImageLine;
using features::radians;

bool go_on(double) {
  return true;
}

TEST(LineScore, MeanMedianAndPercentileByNearestRank) {
  std::vector<double> sizes;
  for (int k = 20; k >= 1; --k) sizes.push_back(k);
  const ErrorSummary summary = summarise_errors(sizes);
  EXPECT_DOUBLE_EQ(summary.mean, 10.5);
  EXPECT_DOUBLE_EQ(summary.median, 10.0);
  EXPECT_DOUBLE_EQ(summary.p95, 19.0);
  EXPECT_TRUE(std::isnan(summarise_errors({}).mean));
}

TEST(LineScore, FoundMeansWithinTwentyPixelsAndThreeDegrees) {
  const ImageLine truth = canonical_line(100.0, 0.0);
  LineScore score;
  score.add(truth, canonical_line(119.9, radians(2.9)));
  score.add(truth, canonical_line(120.1, 0.0));
  score.add(truth, canonical_line(100.0, radians(3.1)));
  score.add(truth, std::nullopt);
  score.add(std::nullopt, std::nullopt);
  score.add(std::nullopt, truth);
  EXPECT_EQ(score.frames_with_line, 4);
  EXPECT_EQ(score.answered, 3);
  EXPECT_DOUBLE_EQ(score.detection_rate(), 0.25);
  EXPECT_DOUBLE_EQ(score.false_alarm_rate(), 0.5);
  EXPECT_EQ(score.rho_px.size(), 3u);
}

TEST(LineScore, WilsonsIntervalInClosedForm) {
  constexpr double z2 = 1.959964 * 1.959964;
  const ShareInterval none = wilson_interval(0, 1000), all = wilson_interval(1000, 1000);
  EXPECT_NEAR(none.low, 0.0, 1e-12);
  EXPECT_NEAR(none.high, z2 / (1000.0 + z2), 1e-12);
  EXPECT_NEAR(all.low, 1.0 - none.high, 1e-12);
  EXPECT_NEAR(all.high, 1.0, 1e-12);
  const ShareInterval half = wilson_interval(5, 10);
  EXPECT_NEAR(half.low + half.high, 1.0, 1e-12);
  EXPECT_NEAR(half.low, 0.2366, 1e-4);
  EXPECT_TRUE(std::isnan(wilson_interval(0, 0).low));
}

TEST(LineScore, TheMirroredBranchIsTheSameLine) {
  LineScore score;
  score.add(canonical_line(100.0, radians(90.0)), canonical_line(-100.0, radians(-89.5)));
  EXPECT_NEAR(score.rho_px.front(), 0.0, 1e-9);
  EXPECT_NEAR(score.theta_deg.front(), 0.5, 1e-9);
}

TEST(LineEvaluation, SubpixelReachesItsGoalsOnAFewFrames) {
  const auto rows = evaluate_lines({.frames = 8, .seed = 3, .methods = {"subpixel"}}, go_on);
  ASSERT_EQ(rows.size(), 12u);  // two sizes, three levels, with and without the tilt
  for (const LineEvaluationRow& row : rows) {
    if (!row.told_tilt) continue;
    const double rho_px = summarise_errors(row.score.rho_px).mean;
    const double theta_deg = summarise_errors(row.score.theta_deg).mean;
    const bool clean = row.level == FrameLevel::clean;
    EXPECT_LE(rho_px, clean ? 0.2 : 1.0) << name_of(row.level) << row.size.width;
    EXPECT_LE(theta_deg, clean ? 0.03 : 0.15) << name_of(row.level) << row.size.width;
    EXPECT_EQ(row.score.detection_rate(), 1.0);
    EXPECT_EQ(row.score.false_alarms, 0);
  }
}

TEST(LineEvaluation, StopsWhenToldTo) {
  const auto rows = evaluate_lines({.frames = 50, .methods = {"centroid"}}, [](double) { return false; });
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].score.frames(), 1);
}

TEST(LineEvaluation, ShowsAsManyFramesWithoutALineAsAskedAtTheLevelsAskedFor) {
  const auto rows =
      evaluate_lines({.frames = 3, .methods = {"centroid"}, .levels = {"harsh"}, .empty_share = 1.0}, go_on);
  ASSERT_EQ(rows.size(), 2u);  // two sizes
  for (const LineEvaluationRow& row : rows) {
    EXPECT_EQ(row.level, FrameLevel::harsh);
    EXPECT_EQ(row.score.frames_without_line, 3);
    EXPECT_EQ(row.score.frames_with_line, 0);
  }
}

TEST(LineEvaluation, RefusesWhatItCannotDo) {
  EXPECT_THROW(evaluate_lines({.frames = 1, .levels = {"filthy"}}, go_on), std::invalid_argument);
  EXPECT_THROW(evaluate_lines({.frames = 1, .empty_share = 1.1}, go_on), std::invalid_argument);
  EXPECT_THROW(evaluate_lines({.frames = 0}, go_on), std::invalid_argument);
  EXPECT_THROW(evaluate_lines({.frames = 1, .methods = {"hough"}}, go_on), std::invalid_argument);
}

LineEvaluationRow row_of(const std::string& method) {
  LineEvaluationRow row{.method = method, .level = FrameLevel::clean, .size = {1920, 1080}, .score = {}};
  row.score.add(canonical_line(100.0, 0.0), canonical_line(102.5, 0.0));
  return row;
}

TEST(LineReport, JsonHasEveryFigureOrNull) {
  const auto json =
      lines_json({.frames = 1, .seed = 7, .methods = {}}, {row_of("skeleton"), row_of("subpixel")});
  EXPECT_EQ(json["settings"]["seed"], 7);
  const auto& row = json["rows"][0];
  EXPECT_DOUBLE_EQ(row["rho_error_px"]["mean"], 2.5);
  EXPECT_DOUBLE_EQ(row["detection_rate"], 1.0);
  EXPECT_TRUE(row["false_alarm_rate"].is_null());
  EXPECT_DOUBLE_EQ(row["published"]["simulated_rho_px"], 5.0);
  EXPECT_TRUE(json["rows"][1]["published"].is_null());
}

TEST(LineReport, CsvHasOneLineARowAndAsManyFieldsAsItsHeader) {
  const std::string csv = lines_csv({row_of("skeleton"), row_of("naive")});
  std::vector<std::ptrdiff_t> commas(1, 0);
  for (const char c : csv) {
    if (c == '\n') commas.push_back(0);
    if (c == ',') ++commas.back();
  }
  ASSERT_EQ(commas.size(), 4u);
  EXPECT_EQ(commas[1], commas[0]);
  EXPECT_EQ(commas[2], commas[0]);
  EXPECT_NE(csv.find("\nskeleton,0,clean,1920,1080,1,0,2.5,"), std::string::npos);
}

TEST(LineReport, TheTableShowsThePublishedFigureBeside) {
  EXPECT_NE(lines_table({row_of("naive")}).find("56 px 3°"), std::string::npos);
  EXPECT_EQ(lines_table({row_of("subpixel")}).find("simulated"), std::string::npos);
}

}  // namespace
}  // namespace lineservo::apps
