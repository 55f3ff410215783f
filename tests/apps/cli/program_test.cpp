// Runs the built program as a user does.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>

#include "apps/config/data_folder.h"
#include "apps/version.h"
#include "servo/law/controllers.h"
#include "tests/apps/test_files.h"

namespace lineservo::apps {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::MatchesRegex;
using testing::read_text;
using ::testing::StartsWith;
using testing::TempFolder;

struct Ran {
  int exit_code = -1;  ///< 128 and the signal's number when a signal ended it
  std::string out, err;
};

class ProgramTest : public ::testing::Test {
 protected:
  /// `largest_file`: bytes that a file may grow to, as on a disk that is full; 0 for no such limit.
  Ran run(const std::vector<std::string>& arguments, rlim_t largest_file = 0) const {
    return run_to(temp_.path() / "stdout", fs::current_path(), arguments, largest_file);
  }
  Ran run_in(const fs::path& folder, const std::vector<std::string>& arguments) const {
    return run_to(temp_.path() / "stdout", folder, arguments, 0);
  }
  Ran run_to(const fs::path& out, const fs::path& folder, const std::vector<std::string>& arguments,
             rlim_t largest_file) const {
    const fs::path err = temp_.path() / "stderr";
    const pid_t child = ::fork();
    if (child == 0) {
      if (::chdir(folder.c_str()) != 0) ::_exit(126);
      become_program(arguments, out, err, largest_file);
    }
    int status = 0;
    EXPECT_EQ(::waitpid(child, &status, 0), child);
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return {code, fs::is_regular_file(out) ? read_text(out) : "", read_text(err)};
  }
  /// Bad input: exit code 2, one line on stderr, nothing on stdout. Returns the line.
  std::string refusal(const std::vector<std::string>& arguments) const {
    const Ran ran = run(arguments);
    EXPECT_EQ(ran.exit_code, 2) << ran.err;
    EXPECT_EQ(ran.out, "");
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
    EXPECT_THAT(ran.err, AllOf(StartsWith("lineservo: "), ::testing::EndsWith("\n")));
    return ran.err;
  }
  fs::path path(const std::string& name) const { return temp_.path() / name; }

  /// A flight of three seconds' wall time at most, to the end of a line of 1.2 m.
  std::vector<std::string> short_flight(const std::vector<std::string>& more = {}) const {
    const fs::path floor = temp_.write("short.yaml",
                                       "name: short\n"
                                       "nodes: [{name: p, x_m: 0, y_m: 0}, {name: q, x_m: 1.2, y_m: 0}]\n"
                                       "edges: [{from: p, to: q, width_m: 0.1}]\n"
                                       "start: {node: p}\n");
    std::vector<std::string> arguments = {"fly",          "node:q",       "--layout",
                                          floor.string(), "--conditions", "ideal"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }

  const TempFolder temp_;

 private:
  [[noreturn]] static void become_program(const std::vector<std::string>& arguments, const fs::path& out,
                                          const fs::path& err, rlim_t largest_file) {
    ::dup2(::open(out.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600), STDOUT_FILENO);
    ::dup2(::open(err.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600), STDERR_FILENO);
    if (largest_file > 0) {
      const rlimit limit{largest_file, largest_file};
      ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    std::vector<char*> argv = {const_cast<char*>("lineservo")};
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    ::execv(LINESERVO_TEST_PROGRAM, argv.data());
    ::_exit(127);
  }
};

TEST_F(ProgramTest, RefusesWhatIsNoCommandLine) {
  EXPECT_THAT(refusal({}), HasSubstr("subcommand is required"));
  EXPECT_THAT(refusal({"flyy"}), HasSubstr("lineservo --help"));
  EXPECT_THAT(refusal({"fly", "a13", "--sped", "1"}), HasSubstr("--sped"));
  EXPECT_THAT(refusal({"fly", "a13", "a14"}), HasSubstr("a14"));
  EXPECT_THAT(refusal({"fly", "a13", "--layout"}), HasSubstr("--layout"));
  EXPECT_THAT(refusal({"layouts", "x"}), HasSubstr("x"));
}

TEST_F(ProgramTest, RefusesAFlightWithoutTarget) {
  EXPECT_THAT(refusal({"fly"}), HasSubstr("TARGET is missing"));
}

TEST_F(ProgramTest, RefusesTargetsThatAreNone) {
  EXPECT_THAT(refusal({"fly", "e13"}),
              AllOf(HasSubstr("'e13' is not an instruction"), HasSubstr("a13"), HasSubstr("d00")));
  EXPECT_THAT(refusal({"fly", "A13"}), HasSubstr("is not an instruction"));
  EXPECT_THAT(refusal({"fly", "a1"}), HasSubstr("is not an instruction"));
  EXPECT_THAT(refusal({"fly", "b04"}), HasSubstr("b00 to b03"));
  EXPECT_THAT(refusal({"fly", "a99"}), AllOf(HasSubstr("no target a99"), HasSubstr("a54")));
  EXPECT_THAT(refusal({"fly", "a00"}), HasSubstr("take-off point"));
  EXPECT_THAT(refusal({"fly", "node:x"}), HasSubstr("no node 'x'"));
  EXPECT_THAT(refusal({"fly", "a13", "--layout", "straight"}), HasSubstr("no target a13"));
}

TEST_F(ProgramTest, RefusesNamesThatDoNotShip) {
  EXPECT_THAT(refusal({"fly", "a13", "--controller", "lqr"}),
              AllOf(HasSubstr("lqr"), HasSubstr("ibvs"), HasSubstr("pid")));
  EXPECT_THAT(refusal({"fly", "a13", "--layout", "hall"}),
              AllOf(HasSubstr("no layout 'hall'"), HasSubstr("warehouse")));
  EXPECT_THAT(refusal({"fly", "a13", "--conditions", "storm"}),
              AllOf(HasSubstr("no conditions 'storm'"), HasSubstr("paper")));
}

TEST_F(ProgramTest, RefusesFilesThatCannotBeReadOrAreWrong) {
  EXPECT_THAT(refusal({"fly", "--config", path("none.yaml")}), HasSubstr("none.yaml: cannot be read"));
  const std::string broken = temp_.write("broken.yaml", "name: x\nnodes: [1, 2\n");
  EXPECT_THAT(refusal({"fly", "a13", "--layout", broken}), HasSubstr("broken.yaml:"));
  const std::string unknown = temp_.write("unknown.yaml", "speed_m_s: 0.1\ncamera: {zoom: 3}\n");
  EXPECT_THAT(refusal({"fly", "a13", "--conditions", unknown}),
              HasSubstr("unknown.yaml:2: unknown key 'camera.zoom'"));
  EXPECT_THAT(refusal({"fly", "a13", "--config", unknown}),
              HasSubstr("unknown.yaml:2: unknown key 'camera.zoom'"));
  EXPECT_THAT(refusal({"fly", "a13", "--config", temp_.path()}), HasSubstr("is a folder"));
}

TEST_F(ProgramTest, RefusesSettingsThatAreNone) {
  EXPECT_THAT(refusal({"fly", "a13", "--set", "camera.zoom=3"}),
              AllOf(HasSubstr("--set"), HasSubstr("'camera.zoom'")));
  EXPECT_THAT(refusal({"fly", "a13", "--set", "speed_m_s"}), HasSubstr("KEY=VALUE"));
  EXPECT_THAT(refusal({"fly", "a13", "--set", "speed_m_s=fast"}), HasSubstr("a number from 0.01 to 2"));
}

TEST_F(ProgramTest, RefusesAVehicleThatCannotBe) {
  EXPECT_THAT(refusal({"fly", "a13", "--set", "vehicle.rotor_radius_m=0.5"}), HasSubstr("must not overlap"));
}

TEST_F(ProgramTest, AFilesNameNeedNotBeUtf8) {
  const Ran ran = run({"detect", temp_.write("\xff.png", "no image").string(), "--json"});
  EXPECT_EQ(ran.exit_code, 1) << ran.err;
  EXPECT_THAT(nlohmann::json::parse(ran.out).at("error"), HasSubstr("not an image"));
}

TEST_F(ProgramTest, RefusesNumbersThatAreNone) {
  for (const char* speed : {"fast", "nan", "inf", "0", "-1", "2.01", "", "0.1x", " 0.1", "1e999"})
    EXPECT_THAT(refusal({"fly", "a13", "--speed", speed}), HasSubstr("speed")) << speed;
  for (const char* seed : {"one", "1.5", "-1", "18446744073709551616", "", "1x", "nan"}) {
    EXPECT_THAT(refusal({"fly", "a13", "--seed", seed}), HasSubstr("seed")) << seed;
    for (const char* what : {"lines", "junctions"})
      EXPECT_THAT(refusal({"evaluate", what, "--seed", seed}), HasSubstr("seed")) << seed;
    EXPECT_THAT(refusal({"train-colour", "--out", path("m.yaml"), "--seed", seed}), HasSubstr("seed"))
        << seed;
  }
  for (const char* count : {"", "-1", "0", "1.5", "nan", "inf", "12x", "100001", "99999999999999999999"}) {
    EXPECT_THAT(refusal({"evaluate", "lines", "--frames", count}), HasSubstr("--frames")) << count;
    EXPECT_THAT(refusal({"train-colour", "--out", path("m.yaml"), "--samples", count}),
                HasSubstr("--samples"))
        << count;
  }
  EXPECT_FALSE(fs::exists(path("m.yaml")));
}

TEST_F(ProgramTest, RefusesToWriteWhereItCannotBeforeItFlies) {
  const std::string file = temp_.write("file", "x");
  EXPECT_THAT(refusal({"fly", "a13", "--out", file}), HasSubstr("--out"));
  EXPECT_THAT(refusal({"fly", "a13", "--out", "/proc/lineservo"}), HasSubstr("--out /proc/lineservo"));
}

TEST_F(ProgramTest, RefusesComparisonsThatAreNone) {
  EXPECT_THAT(refusal({"compare", "--controllers", "ibvs,lqr"}), HasSubstr("lqr"));
  EXPECT_THAT(refusal({"compare", "--controllers", "ibvs,ibvs"}), HasSubstr("named twice"));
  EXPECT_THAT(refusal({"compare", "--instructions", "a13,a99"}), HasSubstr("a99"));
  EXPECT_THAT(refusal({"compare", "--preset", "none"}), HasSubstr("topology, lfpf, grid-flight"));
  EXPECT_THAT(refusal({"compare", "--preset", "topology", "--layout", "bend"}), HasSubstr("excludes"));
  EXPECT_THAT(refusal({"compare", "--own-speed", "--speeds", "0.1"}), HasSubstr("excludes"));
  EXPECT_THAT(refusal({"compare", "--reference", "pid", "--controllers", "ibvs"}), HasSubstr("--reference"));
  for (const char* bad : {"0", "-1", "x"}) {
    EXPECT_THAT(refusal({"compare", std::string("--runs=") + bad}), HasSubstr("--runs"));
    EXPECT_THAT(refusal({"compare", std::string("--jobs=") + bad}), HasSubstr("--jobs"));
    EXPECT_THAT(refusal({"tune", "pid", std::string("--budget=") + bad}), HasSubstr("--budget"));
  }
  EXPECT_THAT(refusal({"tune", "lqr"}), HasSubstr("lqr"));
  EXPECT_THAT(refusal({"tune"}), HasSubstr("CONTROLLER"));
}

TEST_F(ProgramTest, ComparesAndWritesItsThreeFiles) {
  const std::string floor = short_flight()[3];
  const Ran ran = run({"compare", "--instructions", "node:q", "--layout", floor, "--conditions", "ideal",
                       "--controllers", "ibvs,pid", "--runs", "1", "--json", "--out", path("out")});
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_EQ(read_text(path("out/comparison.json")), ran.out);
  const nlohmann::json json = nlohmann::json::parse(ran.out);
  EXPECT_EQ(json["settings"]["reference"], "ibvs");
  EXPECT_GE(json["flights"].size(), 2u);
  EXPECT_GT(fs::file_size(path("out/comparison.csv")), 0u);
  EXPECT_GT(fs::file_size(path("out/distribution.csv")), 0u);
}

TEST_F(ProgramTest, AFullDiskIsOneErrorAndLeavesNothing) {
  const Ran ran = run(short_flight({"--out", path("out")}), 4096);
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_THAT(ran.err, HasSubstr("flight.csv: cannot be written: "));
  EXPECT_TRUE(!fs::exists(path("out")) || fs::is_empty(path("out")));
}

TEST_F(ProgramTest, HelpIsEverywhereAndQuick) {
  const auto begin = std::chrono::steady_clock::now();
  const Ran fly = run({"fly", "--help"});
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(), 0.5);
  EXPECT_EQ(fly.exit_code, 0);
  EXPECT_EQ(fly.err, "");
  for (const char* word : {"TARGET", "--controller", "--layout", "--conditions", "--speed", "--seed", "--set",
                           "--config", "--land", "--explain", "--out", "--json"})
    EXPECT_THAT(fly.out, HasSubstr(word));
  for (const char* command : {"fly", "compare", "tune", "layouts", "controllers", "conditions", "test"}) {
    EXPECT_THAT(run({"--help"}).out, HasSubstr(command));
    EXPECT_EQ(run({command, "--help"}).exit_code, 0) << command;
  }
}

TEST_F(ProgramTest, TellsItsVersion) {
  const Ran ran = run({"--version"});
  EXPECT_EQ(ran.exit_code, 0);
  EXPECT_EQ(ran.out, std::string(kVersion) + "\n");
}

/// The first word of every line.
std::vector<std::string> first_words(const std::string& text) {
  std::vector<std::string> words;
  std::stringstream stream(text);
  for (std::string line; std::getline(stream, line);) words.push_back(line.substr(0, line.find(' ')));
  return words;
}

TEST_F(ProgramTest, ListsWhatShipsALineEach) {
  std::vector<std::string> layouts, conditions, controllers;
  for (const DataEntry& entry : list_data(DataKind::layout)) layouts.push_back(entry.name);
  for (const DataEntry& entry : list_data(DataKind::conditions)) conditions.push_back(entry.name);
  for (const servo::Controller& c : servo::controllers()) controllers.emplace_back(c.name);
  EXPECT_EQ(first_words(run({"layouts"}).out), layouts);
  EXPECT_EQ(first_words(run({"conditions"}).out), conditions);
  EXPECT_EQ(first_words(run({"controllers"}).out), controllers);
  EXPECT_THAT(run({"layouts"}).out, HasSubstr("6 columns and 5 rows"));
}

TEST_F(ProgramTest, ExplainsAPlanWithoutFlying) {
  const Ran ran = run({"fly", "a13", "--explain"});
  EXPECT_EQ(ran.exit_code, 0);
  EXPECT_THAT(ran.out, AllOf(StartsWith("a13: to n13"), HasSubstr("turn 90° left"), HasSubstr("J7→J3"),
                             HasSubstr("hover")));
  EXPECT_EQ(std::count(ran.out.begin(), ran.out.end(), '\n'), 5);
}

TEST_F(ProgramTest, PrintsTheSummaryAsJson) {
  const Ran ran = run(short_flight({"--json"}));
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  const nlohmann::json summary = nlohmann::json::parse(ran.out);
  EXPECT_EQ(summary["outcome"], "arrived");
  EXPECT_EQ(summary["instruction"], "node:q");
  EXPECT_THAT(summary["trajectory_sha256"].get<std::string>(), MatchesRegex("[0-9a-f]+"));
}

TEST_F(ProgramTest, WritesItsFilesAndNoOther) {
  const Ran ran = run(short_flight({"--out", path("a/b")}));
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(path("a/b"))) names.push_back(entry.path().filename());
  EXPECT_THAT(names, ::testing::UnorderedElementsAre("summary.json", "flight.csv", "events.csv",
                                                     "config.yaml", "layout.yaml"));
  EXPECT_EQ(read_text(path("a/b/layout.yaml")), read_text(path("short.yaml")));
  EXPECT_THAT(read_text(path("a/b/flight.csv")), StartsWith("t_s,"));
  EXPECT_THAT(read_text(path("a/b/events.csv")), StartsWith("t_s,kind,detail\n"));
  EXPECT_EQ(nlohmann::json::parse(read_text(path("a/b/summary.json")))["outcome"], "arrived");
}

TEST_F(ProgramTest, ItsConfigRepeatsTheFlight) {
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
TEST_F(ProgramTest, AResultsFolderRepeatsItsFlightFromAnywhere) {
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

TEST_F(ProgramTest, AConfigGoesWithoutConditions) {
  const std::string config = temp_.write("config.yaml", "instruction: a13\n");
  EXPECT_THAT(refusal({"fly", "--config", config, "--conditions", "ideal"}),
              AllOf(HasSubstr("--config"), HasSubstr("--conditions"), HasSubstr("--set")));
}

TEST_F(ProgramTest, RefusesTextThatIsNotUtf8BeforeItFlies) {
  const std::string odd = temp_.write("l\xff.yaml", "name: x\n");
  EXPECT_THAT(refusal({"fly", "a13", "--layout", odd, "--out", path("out")}), HasSubstr("UTF-8"));
  EXPECT_THAT(refusal({"fly", "node:\xc3", "--out", path("out")}), HasSubstr("TARGET"));
  const std::string bytes = temp_.write("bytes.yaml", "name: \"\xff\"\n");
  EXPECT_THAT(refusal({"fly", "a13", "--layout", bytes, "--out", path("out")}), HasSubstr("not UTF-8"));
  EXPECT_FALSE(fs::exists(path("out")));
}

TEST_F(ProgramTest, DetectTellsOfAFileWhoseNameIsNotUtf8) {
  const Ran ran = run({"detect", path("p\xff.jpg"), "--json"});
  EXPECT_EQ(ran.exit_code, 1) << ran.err;
  EXPECT_THAT(nlohmann::json::parse(ran.out)["image"].get<std::string>(), HasSubstr("p\xef\xbf\xbd.jpg"));
}

TEST_F(ProgramTest, AFullOutputIsToldInOneLine) {
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{"layouts"},
                                                    {"--help"},
                                                    {"fly", "a13", "--explain"},
                                                    {"--version"},
                                                    short_flight({"--json"}),
                                                    {"detect", "--json", "/nowhere.jpg"}}) {
    const Ran ran = run_to("/dev/full", fs::current_path(), arguments, 0);
    EXPECT_EQ(ran.exit_code, 2) << arguments.front();
    const bool tells_progress = arguments.front() == "fly" && arguments.back() == "--json";
    if (!tells_progress) {
      EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
    }
    EXPECT_THAT(ran.err, HasSubstr("lineservo: standard output cannot be written")) << arguments.front();
  }
}

TEST_F(ProgramTest, AStudyTakesNothingTwice) {
  EXPECT_THAT(refusal({"tune", "pid", "pid", "--out", path("out")}), HasSubstr("'pid' is named twice"));
  EXPECT_THAT(refusal({"compare", "--controllers", "pid,pid"}), HasSubstr("'pid' is named twice"));
  EXPECT_THAT(refusal({"compare", "--speeds", "0.3,0.3"}), HasSubstr("--speeds: '0.3' is named twice"));
  EXPECT_FALSE(fs::exists(path("out")));
}

TEST_F(ProgramTest, NamesACommandThatItDoesNotKnow) {
  EXPECT_THAT(refusal({"flyy", "a13"}), AllOf(HasSubstr("'flyy'"), HasSubstr("fly, "), HasSubstr("layouts")));
  EXPECT_THAT(refusal({"evaluate", "circles"}), AllOf(HasSubstr("'circles'"), HasSubstr("lines, junctions")));
  EXPECT_THAT(refusal({}), HasSubstr("--help"));
}

TEST_F(ProgramTest, TrainingDoesNotReplaceWhatIsNoFile) {
  const std::vector<std::string> train = {"train-colour", "--samples", "10", "--out"};
  const auto to = [&train](const std::string& out) {
    std::vector<std::string> arguments = train;
    arguments.push_back(out);
    return arguments;
  };
  fs::create_directories(path("folder"));
  EXPECT_THAT(refusal(to("/dev/null")), HasSubstr("/dev/null"));
  EXPECT_THAT(refusal(to(path("folder"))), HasSubstr("it is a folder"));
  EXPECT_THAT(refusal(to("")), HasSubstr("it is a folder"));
  EXPECT_EQ(run(to(path("new.yaml"))).exit_code, 0);
  EXPECT_GT(fs::file_size(path("new.yaml")), 100u);
}

TEST_F(ProgramTest, WhatIsTypedGoesBeforeTheConfig) {
  ASSERT_EQ(run(short_flight({"--out", path("one"), "--seed", "5"})).exit_code, 0);
  const Ran again = run(
      {"fly", "--config", path("one/config.yaml"), "--seed", "6", "--speed", "0.2", "--out", path("two")});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  const auto summary = nlohmann::json::parse(read_text(path("two/summary.json")));
  EXPECT_EQ(summary["seed"], 6);
  EXPECT_EQ(summary["speed_m_s"], 0.2);
  EXPECT_EQ(summary["instruction"], "node:q");
}

TEST_F(ProgramTest, AMissionThatFailsEndsWithOneAndStillWritesEverything) {
  const Ran ran = run(short_flight({"--set", "time_limit_s=3", "--out", path("out")}));
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_THAT(ran.out, HasSubstr("timeout"));
  for (const char* name : {"summary.json", "flight.csv", "events.csv", "config.yaml"})
    EXPECT_GT(fs::file_size(path("out") / name), 0u) << name;
}

}  // namespace
}  // namespace lineservo::apps
