#include "apps/report/flight_data.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "apps/output/flight_tables.h"
#include "tests/apps/flight/test_flight.h"

namespace lineservo::apps {
namespace {

using nlohmann::json;

/// One flight of a13, and its report.
class FlightDataTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    mission_ = new Mission(prepare(testing::request_for("a13", "paper")));
    flown_ = new FlownMission(fly_mission(*mission_));
    data_ = new json(json::parse(flight_data(*mission_, flown_->record, flown_->summary)));
  }
  static void TearDownTestSuite() {
    delete data_;
    delete flown_;
    delete mission_;
  }
  static const json& ticks() { return (*data_)["ticks"]; }
  /// Whether a flag or code of the ticks is this value.
  static long count(const char* column, const json& value) {
    return std::count(ticks()[column].begin(), ticks()[column].end(), value);
  }

  static inline const Mission* mission_ = nullptr;
  static inline const FlownMission* flown_ = nullptr;
  static inline const json* data_ = nullptr;
};

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts;
  std::stringstream stream(text);
  for (std::string part; std::getline(stream, part, at);) parts.push_back(part);
  return parts;
}

TEST_F(FlightDataTest, HasTheNumbersOfTheTable) {
  const std::vector<std::string> lines = split(flight_csv(flown_->record), '\n');
  const std::vector<std::string> names = split(lines[0], ',');
  std::size_t compared = 0;
  for (std::size_t column = 0; column < names.size(); ++column) {
    if (!ticks().contains(names[column])) continue;
    const json& values = ticks()[names[column]];
    ASSERT_EQ(values.size(), lines.size() - 1) << names[column];
    for (std::size_t row = 0; row < values.size(); ++row) {
      const std::string cell = split(lines[row + 1], ',')[column];
      if (values[row].is_null())
        ASSERT_EQ(cell, "nan") << names[column] << " " << row;
      else
        ASSERT_EQ(values[row].get<double>(), std::stod(cell)) << names[column] << " " << row;
    }
    ++compared;
  }
  EXPECT_EQ(compared, 20u);
}

TEST_F(FlightDataTest, HasTheSummary) {
  EXPECT_EQ((*data_)["kind"], "flight");
  EXPECT_EQ((*data_)["summary"], json::parse(to_json(mission_->request, flown_->summary).dump()));
}

TEST_F(FlightDataTest, TheErrorIsThatOfTheScore) {
  double sum = 0.0, largest_m = 0.0;
  long samples = 0;
  for (const json& error : ticks()["error_m"]) {
    if (error.is_null()) continue;
    sum += error.get<double>() * error.get<double>();
    largest_m = std::max(largest_m, std::abs(error.get<double>()));
    ++samples;
  }
  const OffsetStatistics& all = flown_->summary.track.all;
  EXPECT_NEAR(std::sqrt(sum / static_cast<double>(samples)), all.rmse_m, 0.05 * all.rmse_m);
  EXPECT_LE(largest_m, all.max_m + 1e-6);
  EXPECT_GT(largest_m, 0.8 * all.max_m);
}

TEST_F(FlightDataTest, DeadReckoningBeginsAtTheStartAndDriftsAsTheVelocityIsBiased) {
  const auto off_m = [](std::size_t k) {
    return std::hypot(ticks()["reckoned_x_m"][k].get<double>() - ticks()["x_m"][k].get<double>(),
                      ticks()["reckoned_y_m"][k].get<double>() - ticks()["y_m"][k].get<double>());
  };
  const std::size_t last = ticks()["t_s"].size() - 1;
  EXPECT_LT(off_m(0), 0.001);
  EXPECT_LT(off_m(50), 0.3);  // 5 s
  EXPECT_GT(off_m(last), 0.01);
  EXPECT_LT(off_m(last), 8.0);  // of 10.7 m flown in 123 s: a bias of 0.03 m/s and of the heading
}

TEST_F(FlightDataTest, MarksBothLegsAndTheTurnBetween) {
  const std::size_t turning = static_cast<std::size_t>(
      std::find(ticks()["turning"].begin(), ticks()["turning"].end(), 1) - ticks()["turning"].begin());
  ASSERT_LT(turning, ticks()["turning"].size());
  EXPECT_EQ(ticks()["leg"][turning], 0);
  EXPECT_GT(count("leg", 0), 100);
  EXPECT_GT(count("leg", 1), 100);
  EXPECT_EQ(count("leg", 2), 0);
}

TEST_F(FlightDataTest, TrueCodesAreThoseOfTheScore) {
  const JunctionScore& score = flown_->summary.junctions;
  EXPECT_EQ(static_cast<long>(ticks()["code_true"].size()) - count("code_true", nullptr), score.frames);
  long wrong = 0;
  for (std::size_t k = 0; k < ticks()["code_true"].size(); ++k)
    wrong += !ticks()["code_true"][k].is_null() && ticks()["code_true"][k] != ticks()["code_raw"][k] ? 1 : 0;
  EXPECT_EQ(wrong, score.misclassified);
}

TEST_F(FlightDataTest, TheWayGoesOverTheCornerToTheTarget) {
  const json& route = (*data_)["route"];
  ASSERT_EQ(route.size(), 2u);
  EXPECT_EQ(route[0]["points"].front(), json({0.6, 0.6}));
  EXPECT_EQ(route[0]["points"].back(), json({4.2, 0.6}));
  EXPECT_EQ(route[1]["points"].front(), json({4.2, 0.6}));
  EXPECT_EQ(route[1]["points"].back(), json({4.2, 7.4}));
}

TEST_F(FlightDataTest, HasTheFloorWithColoursForThePage) {
  const json& floor = (*data_)["floor"];
  EXPECT_EQ(floor["nodes"].size(), mission_->floor.nodes.size());
  EXPECT_EQ(floor["lines"].size(), mission_->floor.edges.size());
  EXPECT_EQ(floor["lines"][0]["width_m"], 0.36);
  EXPECT_THAT(floor["lines"][0]["colour"].get<std::string>(), ::testing::MatchesRegex("#[0-9a-f]+"));
  EXPECT_EQ(floor["markers"][0]["kind"], "start");
}

TEST_F(FlightDataTest, StandsBesideThePublishedFiguresOfItsInstruction) {
  const json& rows = (*data_)["published"]["rows"];
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0]["title"], "a13");
  EXPECT_EQ(rows[0]["terminal_error_m"], 0.16);
  EXPECT_EQ((*data_)["published"]["ranges"].size(), 4u);
}

TEST_F(FlightDataTest, ThumbnailsAreThereWhenThereAreAny) {
  EXPECT_TRUE((*data_)["thumbnails"].empty());
  const json data = json::parse(
      flight_data(*mission_, flown_->record, flown_->summary, {{1.5, "data:image/png;base64,AA=="}}));
  EXPECT_EQ(data["thumbnails"][0]["t_s"], 1.5);
  EXPECT_EQ(data["thumbnails"][0]["uri"], "data:image/png;base64,AA==");
}

TEST(FlightData, OfAFlightWithoutATickHasEmptyColumns) {
  const Mission mission = prepare(testing::request_for("a13", "paper"));
  const FlightRecord nothing;
  const FlightSummary summary = summarise(mission.request, mission.floor, mission.plan, nothing);
  const json data = json::parse(flight_data(mission, nothing, summary));
  for (const auto& [name, column] : data["ticks"].items()) EXPECT_TRUE(column.empty()) << name;
}

TEST(FlightData, ALoopIsARoundWayOfManyPoints) {
  FlightRequest request = testing::request_for("d00", "paper");
  request.layout = layout_of_zone(request.instruction);
  const Mission mission = prepare(request);
  const FlightRecord nothing;
  const FlightSummary summary = summarise(mission.request, mission.floor, mission.plan, nothing);
  const json route = json::parse(flight_data(mission, nothing, summary))["route"];
  ASSERT_GT(route[0]["points"].size(), 100u);
  for (const json& point : route[0]["points"])
    EXPECT_NEAR(std::hypot(point[0].get<double>(), point[1].get<double>()), 5.3, 0.001);
}

}  // namespace
}  // namespace lineservo::apps
