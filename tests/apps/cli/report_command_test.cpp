#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "apps/report/report_page.h"
#include "tests/apps/cli/program_test.h"

namespace lineservo::apps {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using testing::read_text;

class ReportCommandTest : public ProgramTest {
 protected:
  void SetUp() override { ASSERT_EQ(run(short_flight({"--out", path("flight")})).exit_code, 0); }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(path("flight") / name) << text;
  }
  std::string text_of_report() const {
    return fs::exists(path("flight/report.html")) ? read_text(path("flight/report.html")) : "";
  }
};

/// The data of a report but for the names of the user's files and the timings.
nlohmann::json data_of(const fs::path& report) {
  const std::string html = read_text(report), tag = "type=\"application/json\">";
  const std::size_t begin = html.find(tag) + tag.size();
  auto data = nlohmann::json::parse(html.substr(begin, html.find("</script>", begin) - begin));
  for (const char* name : {"timing", "layout"}) data["summary"].erase(name);
  return data;
}

TEST_F(ReportCommandTest, WritesTheReportOfTheFlightAgain) {
  if (!find_report_page()) GTEST_SKIP() << "the page was not built: npm was not to be had";
  const auto before = data_of(path("flight/report.html"));
  EXPECT_GT(before["thumbnails"].size(), 10u);
  fs::remove(path("flight/report.html"));
  const Ran ran = run({"report", path("flight")});
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_THAT(ran.out, HasSubstr("report.html"));
  EXPECT_EQ(data_of(path("flight/report.html")), before);
  EXPECT_TRUE(fs::exists(path("flight/summary.json")));
}

TEST_F(ReportCommandTest, AFlightThatIsNotThatOfTheFolderIsNoneOfIt) {
  auto summary = nlohmann::json::parse(read_text(path("flight/summary.json")));
  summary["trajectory_sha256"] = "0";
  write("summary.json", summary.dump());
  const std::string report = text_of_report();
  const Ran ran = run({"report", path("flight")});
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_THAT(ran.err, HasSubstr("flies otherwise"));
  EXPECT_EQ(text_of_report(), report);
}

TEST_F(ReportCommandTest, ATableThatIsNotThatOfTheFlightIsNoneOfIt) {
  write("flight.csv", "t_s\n0\n");
  const Ran ran = run({"report", path("flight")});
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_THAT(ran.err, HasSubstr("flight.csv is not that of the flight"));
}

// Nodes of other names are flown to in the same way to the last bit, and the report's map is another.
TEST_F(ReportCommandTest, AFloorThatIsNotThatOfTheFlightIsNamed) {
  const std::string report = text_of_report();
  write("layout.yaml",
        "name: short\n"
        "nodes: [{name: o, x_m: 0, y_m: 0}, {name: q, x_m: 1.2, y_m: 0}]\n"
        "edges: [{from: o, to: q, width_m: 0.1}]\n"
        "start: {node: o}\n");
  const Ran ran = run({"report", path("flight")});
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_EQ(ran.err, "lineservo: " + path("flight").string() +
                         ": summary.json is not of the flight of config.yaml: legs/0/from is \"p\", "
                         "flown again \"o\"\n");
  EXPECT_EQ(text_of_report(), report);
}

TEST_F(ReportCommandTest, ASummaryThatWasChangedIsNamed) {
  auto summary = nlohmann::json::parse(read_text(path("flight/summary.json")));
  summary["legs"][0]["rmse_m"] = 0.25;
  summary["timing"]["wall_s"] = 77.0;  // which is other each time
  write("summary.json", summary.dump());
  const Ran ran = run({"report", path("flight")});
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_THAT(ran.err, HasSubstr("summary.json is not of the flight of config.yaml: legs/0/rmse_m is 0.25, "
                                 "flown again 0."));
  summary["legs"][0]["rmse_m"] = nullptr;
  summary["layout"] = "warehouse";
  write("summary.json", summary.dump());
  EXPECT_EQ(run({"report", path("flight")}).exit_code, 1);
}

TEST_F(ReportCommandTest, RefusesWhatIsNoFolderOfAFlight) {
  EXPECT_THAT(refusal({"report"}), HasSubstr("DIR"));
  EXPECT_THAT(refusal({"report", path("nowhere")}), HasSubstr("nowhere"));
  for (const char* text : {"", "{", "[]", "{}", "{\"trajectory_sha256\": 1}"}) {
    write("summary.json", text);
    EXPECT_THAT(refusal({"report", path("flight")}), HasSubstr("summary.json")) << text;
  }
}

}  // namespace
}  // namespace lineservo::apps
