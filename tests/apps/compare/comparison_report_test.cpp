#include "apps/compare/comparison_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "apps/compare/comparison_table.h"
#include "tests/apps/compare/short_study.h"

namespace lineservo::apps {
namespace {

using nlohmann::ordered_json;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::ShortStudy;

class ComparisonReport : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    const ShortStudy study;
    result_ = study.fly(2);
  }
  static ComparisonResult result_;
};
ComparisonResult ComparisonReport::result_;

TEST_F(ComparisonReport, JsonHasEveryFieldOfTheContract) {
  const ordered_json json = comparison_json(result_);
  for (const char* key : {"settings", "controllers", "pairs", "flights"}) EXPECT_TRUE(json.contains(key));
  for (const char* key : {"name",          "tuned",
                          "adaptations",   "runs",
                          "arrived",       "success_rate",
                          "success_ci95",  "rmse_m",
                          "max_m",         "mean_m",
                          "p95_m",         "settled_rmse_m",
                          "turn_max_m",    "terminal_error_m",
                          "duration_s",    "tilt_rate_rms_rad_s",
                          "perception_ms", "control_ms",
                          "outcomes",      "layout",
                          "speed_m_s"})
    EXPECT_TRUE(json["controllers"][0].contains(key)) << key;
  for (const char* key : {"a", "b", "metric", "difference", "ci95"})
    EXPECT_TRUE(json["pairs"][0].contains(key)) << key;
  for (const char* key : {"controller", "instruction", "seed", "speed_m_s", "outcome", "rmse_m", "max_m",
                          "terminal_error_m", "command"})
    EXPECT_TRUE(json["flights"][0].contains(key)) << key;
}

TEST_F(ComparisonReport, JsonFiguresAreThoseOfTheFlights) {
  const ordered_json json = comparison_json(result_);
  const ordered_json& pid = json["controllers"][0];
  EXPECT_EQ(pid["name"], "pid");
  EXPECT_EQ(pid["adaptations"].size(), 2u);
  const double mean =
      (json["flights"][0]["rmse_m"].get<double>() + json["flights"][1]["rmse_m"].get<double>()) / 2;
  EXPECT_NEAR(pid["rmse_m"].get<double>(), mean, 1e-15);
  EXPECT_LE(pid["success_ci95"][0], pid["success_rate"]);
  EXPECT_EQ(json["settings"]["reference"], "ibvs");
  EXPECT_EQ(json["pairs"][0]["a"], "pid");
  EXPECT_FALSE(json["settings"].contains("jobs"));
}

TEST_F(ComparisonReport, CsvIsALineForEachRowWithAllItsColumns) {
  const std::string csv = comparison_csv(result_);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3);
  std::stringstream lines(csv);
  std::vector<long> commas;
  for (std::string line; std::getline(lines, line);)
    commas.push_back(std::count(line.begin(), line.end(), ','));
  EXPECT_EQ(commas[0], commas[1]);
  EXPECT_EQ(commas[0], commas[2]);
}

TEST_F(ComparisonReport, DistributionHoldsEverySample) {
  const std::string csv = distribution_csv(result_);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 2 * 20);
  const TrackScore& track = result_.contestants[0].flights[0].summary.track;
  long samples = 0;
  for (const long n : track.distribution) samples += n;
  EXPECT_EQ(samples, track.legs[0].samples);
}

TEST_F(ComparisonReport, TableNamesRowsDifferencesAndAdaptations) {
  const std::string table = comparison_table(result_);
  EXPECT_THAT(table, AllOf(HasSubstr("pid *"), HasSubstr("2 of 2"), HasSubstr("pid - ibvs"),
                           HasSubstr("in the place of a compass"), Not(HasSubstr("failed"))));
  EXPECT_THAT(error_histogram(result_), AllOf(HasSubstr("0 to 5 cm"), HasSubstr("#")));
}

TEST_F(ComparisonReport, TableTellsHowToFlyAFailureAgain) {
  ComparisonResult failed = result_;
  failed.contestants[0].flights[1].summary.outcome = "lost_line";
  EXPECT_THAT(comparison_table(failed),
              AllOf(HasSubstr("failed flights: 1, 1 lost_line"), HasSubstr("lineservo fly node:q")));
}

TEST_F(ComparisonReport, PublishedFiguresStandBesideAPreset) {
  ComparisonResult preset = result_;
  for (Contestant& c : preset.contestants) c.entry.title = "a13";
  preset.options.blocks[0].title = "a13";
  EXPECT_TRUE(comparison_json(preset)["published"].empty());
  preset.preset = "topology";
  EXPECT_EQ(comparison_json(preset)["published"][0]["terminal_error_m"], 0.16);
  EXPECT_THAT(comparison_table(preset), AllOf(HasSubstr("published: pid"), HasSubstr("92.73")));
}

}  // namespace
}  // namespace lineservo::apps
