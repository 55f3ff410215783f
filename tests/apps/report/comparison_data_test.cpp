#include "apps/report/comparison_data.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <numeric>

#include "tests/apps/compare/short_study.h"

namespace lineservo::apps {
namespace {

using nlohmann::json;

class ComparisonDataTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    study_ = new testing::ShortStudy;
    result_ = new ComparisonResult(study_->fly(1));
    data_ = new json(json::parse(comparison_data(*result_)));
  }
  static void TearDownTestSuite() {
    delete data_;
    delete result_;
    delete study_;
  }

  static inline const testing::ShortStudy* study_ = nullptr;
  static inline const ComparisonResult* result_ = nullptr;
  static inline const json* data_ = nullptr;
};

/// The sum of every second number: of run lengths and of bins.
long total(const json& pairs) {
  long sum = 0;
  for (std::size_t i = 1; i < pairs.size(); i += 2) sum += pairs[i].get<long>();
  return sum;
}

TEST_F(ComparisonDataTest, HoldsTheComparison) {
  EXPECT_EQ((*data_)["kind"], "comparison");
  EXPECT_EQ((*data_)["comparison"], json::parse(comparison_json(*result_).dump()));
}

TEST_F(ComparisonDataTest, EveryErrorIsInABin) {
  const json& controllers = (*data_)["comparison"]["controllers"];
  for (std::size_t row = 0; row < controllers.size(); ++row) {
    const auto coarse = controllers[row]["error_distribution"].get<std::vector<long>>();
    EXPECT_EQ(total((*data_)["errors"]["rows"][row]), std::accumulate(coarse.begin(), coarse.end(), 0L));
    EXPECT_GT(total((*data_)["errors"]["rows"][row]), 100);
  }
}

TEST_F(ComparisonDataTest, AMeanLiesInItsInterval) {
  for (std::size_t row = 0; row < 2; ++row) {
    const json& ci95 = (*data_)["mean_ci95"][row]["rmse_m"];
    const double mean = (*data_)["comparison"]["controllers"][row]["rmse_m"];
    EXPECT_LE(ci95[0].get<double>(), mean);
    EXPECT_GE(ci95[1].get<double>(), mean);
  }
}

TEST_F(ComparisonDataTest, TracesTheFirstRunOfEachRow) {
  const json& traces = (*data_)["traces"];
  ASSERT_EQ(traces.size(), 2u);
  for (std::size_t row = 0; row < 2; ++row) {
    EXPECT_EQ(traces[row]["row"], row);
    EXPECT_EQ(traces[row]["seed"], study_->options.seed);
    EXPECT_EQ(traces[row]["route"].size(), 1u);
    for (const char* column : {"t_s", "x_m", "y_m", "error_m", "leg"})
      EXPECT_EQ(traces[row]["path"][column].size(), traces[row]["path"]["t_s"].size()) << column;
    EXPECT_GT(traces[row]["path"]["t_s"].size(), 20u);
  }
  EXPECT_EQ((*data_)["floors"].size(), 1u);
}

TEST_F(ComparisonDataTest, EveryWindowHasEveryFrame) {
  const json& codes = (*data_)["traces"][0]["codes"];
  ASSERT_EQ(codes["windows"].size(), 4u);
  EXPECT_EQ(codes["windows"][0]["frames"], 1);
  EXPECT_EQ(codes["windows"][3]["frames"], 9);
  const long frames = static_cast<long>(result_->contestants[0].flights[0].trace->codes.size());
  for (const json& window : codes["windows"]) EXPECT_EQ(total(window["runs"]), frames);
  EXPECT_EQ(total(codes["true"]), frames);
  EXPECT_EQ(total(codes["raw"]), frames);
}

TEST_F(ComparisonDataTest, IsTheSameForAnyNumberOfJobsButForTheTimings) {
  json again = json::parse(comparison_data(study_->fly(2)));
  EXPECT_EQ(again["traces"], (*data_)["traces"]);
  EXPECT_EQ(again["errors"], (*data_)["errors"]);
}

}  // namespace
}  // namespace lineservo::apps
