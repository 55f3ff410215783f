// The command lines that the pages show are ones that the program takes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <sstream>
#include <utility>

#include "apps/cli/program.h"
#include "apps/flight/mission.h"
#include "tests/apps/test_files.h"

namespace lineservo::apps {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using Words = std::vector<std::string>;

/// The commands of a line of shell, up to a comment: words with their quotes taken off.
std::vector<Words> commands_of(const std::string& line) {
  std::vector<Words> commands(1);
  std::string word;
  const auto end_word = [&] {
    if (!word.empty()) commands.back().push_back(std::exchange(word, {}));
  };
  for (std::size_t k = 0; k < line.size(); ++k) {
    const char c = line[k];
    if (c == '#' && word.empty()) break;
    if (c == '"' || c == '\'') {
      const std::size_t end = std::min(line.find(c, k + 1), line.size());
      word += line.substr(k + 1, end - k - 1);
      k = end;
    } else if (std::string(" \t").find(c) != std::string::npos) {
      end_word();
    } else if (c == '(' && !word.empty()) {  // find_package(lineservo) runs nothing
      word += c;
    } else if (std::string(";&|>()").find(c) != std::string::npos) {
      end_word();
      commands.emplace_back();
    } else {
      word += c;
    }
  }
  end_word();
  return commands;
}

/// The program, or that of the guide, which is the program with one more controller.
bool is_program(const std::string& word) {
  return word == "lineservo" || word.ends_with("/lineservo") || word == "build/example/proportional";
}

/// What follows the program's name in each command of it.
std::vector<Words> arguments_in(const std::string& line) {
  std::vector<Words> list;
  for (const Words& words : commands_of(line)) {
    if (!words.empty() && is_program(words[0])) list.emplace_back(words.begin() + 1, words.end());
  }
  return list;
}

/// Lines of the fenced blocks, those that end with a backslash joined, and what stands between single
/// backticks.
std::vector<std::string> shell_lines(const std::string& page) {
  std::vector<std::string> lines;
  std::stringstream stream(page);
  bool fenced = false, goes_on = false;
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("```")) {
      fenced = !fenced;
      continue;
    }
    if (fenced && goes_on) {
      lines.back() += line;
    } else if (fenced) {
      lines.push_back(line);
    } else {
      static const std::regex kCode("`([^`]+)`");
      for (std::sregex_iterator code(line.begin(), line.end(), kCode), none; code != none; ++code)
        lines.push_back((*code)[1]);
    }
    goes_on = fenced && lines.back().ends_with('\\');
    if (goes_on) lines.back().pop_back();
  }
  return lines;
}

std::vector<fs::path> pages() {
  const fs::path root = fs::path(LINESERVO_TEST_DATA).parent_path();
  std::vector<fs::path> list = {root / "README.md"};
  for (const char* folder : {"apps", "data", "features", "servo", "vehicle"})
    for (const fs::path& file : fs::recursive_directory_iterator(root / folder))
      if (file.extension() == ".md") list.push_back(file);
  return list;
}

TEST(DocumentedCommands, AreOnesThatTheProgramTakes) {
  std::size_t checked = 0;
  for (const fs::path& page : pages()) {
    for (const std::string& line : shell_lines(testing::read_text(page))) {
      for (const Words& arguments : arguments_in(line)) {
        EXPECT_EQ(fault_in(arguments).value_or(""), "") << page << ": " << line;
        ++checked;
      }
    }
  }
  EXPECT_GT(checked, 60u);
}

TEST(DocumentedCommands, TheLayoutOfTheGuideIsTheOneThatItsPageShowsAndCanBeFlown) {
  const fs::path guide = fs::path(LINESERVO_TEST_DATA).parent_path() / "apps/guide";
  EXPECT_THAT(testing::read_text(guide / "own-layout.md"),
              HasSubstr("```yaml\n" + testing::read_text(guide / "loft.yaml") + "```\n"));
  FlightRequest request;
  request.layout = guide / "loft.yaml";
  for (const char* instruction : {"a01", "a11"}) {
    request.instruction = instruction;
    EXPECT_EQ(prepare(request).plan.steps.size(), 2u) << instruction;
  }
}

TEST(DocumentedCommands, AreFoundAsAShellReadsThem) {
  EXPECT_THAT(arguments_in("cd x && ./lineservo fly a13 --set a=1; lineservo fly 'a 1'   # and more: fly"),
              ElementsAre(ElementsAre("fly", "a13", "--set", "a=1"), ElementsAre("fly", "a 1")));
  EXPECT_THAT(arguments_in("fly a13"), IsEmpty());
  EXPECT_THAT(shell_lines("text `lineservo test` and\n```\none \\\n  two\nthree\n```\n`four`"),
              ElementsAre("lineservo test", "one   two", "three", "four"));
}

TEST(DocumentedCommands, ThatWouldBeRefusedAreTold) {
  EXPECT_THAT(fault_in({"flyy", "a13"}).value_or(""), HasSubstr("'flyy'"));
  EXPECT_THAT(fault_in({"fly", "a13", "--sped", "1"}).value_or(""), HasSubstr("--sped"));
  EXPECT_THAT(fault_in({"fly", "a13", "--record"}).value_or(""), HasSubstr("--out"));
  EXPECT_EQ(fault_in({"fly", "--help"}), std::nullopt);
  EXPECT_EQ(fault_in({"fly", "a13", "--out", "/nowhere"}), std::nullopt);
}

}  // namespace
}  // namespace lineservo::apps
