#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/apps/cli/program_test.h"

namespace lineservo::apps {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::read_text;
using FlyConfigTest = ProgramTest;

TEST_F(FlyConfigTest, ItsConfigRepeatsTheFlight) {
  const Ran first = run(
      short_flight({"--out", path("one"), "--seed", "5", "--speed", "0.25", "--set", "wind.mean_m_s=0.5"}));
  ASSERT_EQ(first.exit_code, 0) << first.err;
  const Ran again = run({"fly", "--config", path("one/config.yaml"), "--out", path("two")});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  const auto hash = [this](const std::string& folder) {
    return nlohmann::json::parse(read_text(path(folder) / "summary.json"))["trajectory_sha256"];
  };
  EXPECT_EQ(hash("one"), hash("two"));
  EXPECT_EQ(read_text(path("one/config.yaml")), read_text(path("two/config.yaml")));
  EXPECT_EQ(read_text(path("one/flight.csv")), read_text(path("two/flight.csv")));
}

// The layout and the conditions lie beside the config: neither the originals nor the current folder matter.
TEST_F(FlyConfigTest, AResultsFolderRepeatsItsFlightFromAnywhere) {
  const fs::path calm = temp_.write("calm.yaml", "speed_m_s: 0.4\n");
  std::vector<std::string> arguments = short_flight({"--out", path("one")});
  *std::find(arguments.begin(), arguments.end(), "ideal") = calm.string();
  ASSERT_EQ(run(arguments).exit_code, 0);
  const auto before = nlohmann::json::parse(read_text(path("one/summary.json")));
  fs::remove(path("short.yaml"));
  fs::remove(calm);
  fs::create_directories(path("far/away"));
  fs::rename(path("one"), path("far/away/moved"));
  const Ran again = run_in(path("far"), {"fly", "--config", "away/moved/config.yaml", "--out", path("two")});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  const auto after = nlohmann::json::parse(read_text(path("two/summary.json")));
  EXPECT_EQ(after["trajectory_sha256"], before["trajectory_sha256"]);
  EXPECT_EQ(read_text(path("two/config.yaml")), read_text(path("far/away/moved/config.yaml")));
  EXPECT_EQ(run_in(path("far/away/moved"), {"fly", "--config", "config.yaml", "--explain"}).exit_code, 0);
}

TEST_F(FlyConfigTest, AConfigGoesWithoutConditions) {
  const std::string config = temp_.write("config.yaml", "instruction: a13\n");
  EXPECT_THAT(refusal({"fly", "--config", config, "--conditions", "ideal"}),
              AllOf(HasSubstr("--config"), HasSubstr("--conditions"), HasSubstr("--set")));
}

TEST_F(FlyConfigTest, WhatIsTypedGoesBeforeTheConfig) {
  ASSERT_EQ(run(short_flight({"--out", path("one"), "--seed", "5"})).exit_code, 0);
  const Ran again = run(
      {"fly", "--config", path("one/config.yaml"), "--seed", "6", "--speed", "0.2", "--out", path("two")});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  const auto summary = nlohmann::json::parse(read_text(path("two/summary.json")));
  EXPECT_EQ(summary["seed"], 6);
  EXPECT_EQ(summary["speed_m_s"], 0.2);
  EXPECT_EQ(summary["instruction"], "node:q");
}

}  // namespace
}  // namespace lineservo::apps
