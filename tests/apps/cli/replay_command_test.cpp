#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/apps/cli/program_test.h"

namespace lineservo::apps {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::read_text;
using ::testing::StartsWith;

class ReplayProgram : public ProgramTest {
 protected:
  Ran record(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = short_flight(
        {"--set", "camera.width_px=320", "--set", "camera.height_px=240", "--set", "camera.focal_px=160"});
    arguments.insert(arguments.end(), {"--out", folder_});
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }
  void change_byte(const fs::path& file, std::size_t at) const {
    std::string bytes = read_text(file);
    bytes.at(at) = static_cast<char>(bytes[at] ^ 1);
    std::ofstream(file, std::ios::binary) << bytes;
  }
  const std::string folder_ = path("flight");
};

TEST_F(ReplayProgram, TellsAnUntouchedRecordingFromAChangedOne) {
  ASSERT_EQ(record({"--record"}).exit_code, 0);
  const Ran same = run({"replay", folder_});
  EXPECT_EQ(same.exit_code, 0) << same.err;
  EXPECT_THAT(same.out, HasSubstr("the same features and commands to the last bit"));

  const Ran other = run({"replay", folder_, "--controller", "pid"});
  EXPECT_EQ(other.exit_code, 0) << other.err;
  EXPECT_THAT(other.out,
              AllOf(StartsWith("t_s,frame,recorded.ibvs.forward_m_s,"), HasSubstr(",pid.left_m_s,")));
  EXPECT_GT(std::count(other.out.begin(), other.out.end(), '\n'), 200);
  EXPECT_THAT(refusal({"replay", folder_, "--controller", "none"}), HasSubstr("unknown controller 'none'"));

  change_byte(path("flight/frames/000100.png"), 500);
  const Ran changed = run({"replay", folder_});
  EXPECT_EQ(changed.exit_code, 1);
  EXPECT_EQ(changed.out, "");
  EXPECT_EQ(std::count(changed.err.begin(), changed.err.end(), '\n'), 1);
  EXPECT_THAT(changed.err, HasSubstr("frame frames/000100.png is not the one that was recorded"));
}

// The recording belongs to the flight beside it: the next flight into the folder takes its place, or it goes.
TEST_F(ReplayProgram, ALaterFlightReplacesTheRecordingOrRemovesIt) {
  ASSERT_EQ(record({"--record"}).exit_code, 0);
  ASSERT_EQ(record({"--record", "--seed", "2"}).exit_code, 0);
  EXPECT_EQ(run({"replay", folder_}).exit_code, 0);
  ASSERT_EQ(record().exit_code, 0);
  EXPECT_FALSE(fs::exists(path("flight/frames")));
  EXPECT_FALSE(fs::exists(path("flight/recording.csv")));
  EXPECT_FALSE(fs::exists(path("flight/recording.json")));
  EXPECT_TRUE(fs::exists(path("flight/summary.json")));
}

TEST_F(ReplayProgram, RecordingDoesNotChangeTheFlight) {
  ASSERT_EQ(record({"--record"}).exit_code, 0);
  const std::string recorded = read_text(path("flight/flight.csv"));
  ASSERT_EQ(record().exit_code, 0);
  EXPECT_EQ(read_text(path("flight/flight.csv")), recorded);
}

// A folder of the user's own that happens to be named so is not touched.
TEST_F(ReplayProgram, DoesNotReplaceAFolderThatIsNoRecordings) {
  fs::create_directories(path("flight/frames"));
  std::ofstream(path("flight/frames/000000.png")) << "mine";
  EXPECT_THAT(record({"--record"}).err, HasSubstr("frames: is there already, and not from an earlier run"));
  ASSERT_EQ(record().exit_code, 0);
  EXPECT_EQ(read_text(path("flight/frames/000000.png")), "mine");
}

TEST_F(ReplayProgram, RefusesARecordingOfAnotherVersion) {
  ASSERT_EQ(record({"--record"}).exit_code, 0);
  auto info = nlohmann::json::parse(read_text(path("flight/recording.json")));
  const std::string version = info["version"];
  info["version"] = "0.0.9";
  std::ofstream(path("flight/recording.json")) << info.dump();
  for (const char* command : {"replay", "watch"})
    EXPECT_THAT(refusal({command, folder_}),
                AllOf(HasSubstr("recording.json: is of version 0.0.9"), HasSubstr("allowed: " + version)));
}

TEST_F(ReplayProgram, RefusesWhatIsNoRecording) {
  EXPECT_THAT(refusal({"replay"}), HasSubstr("DIR"));
  EXPECT_THAT(refusal({"replay", path("none")}), HasSubstr("is not the folder of a recording"));
  EXPECT_THAT(refusal({"fly", "a13", "--record"}), HasSubstr("--out"));
}

}  // namespace
}  // namespace lineservo::apps
