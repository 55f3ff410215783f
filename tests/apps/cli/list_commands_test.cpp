#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "apps/config/data_folder.h"
#include "servo/law/controllers.h"
#include "tests/apps/cli/program_test.h"

namespace lineservo::apps {
namespace {

using ::testing::HasSubstr;
using ListCommandsTest = ProgramTest;

/// The first word of every line.
std::vector<std::string> first_words(const std::string& text) {
  std::vector<std::string> words;
  std::stringstream stream(text);
  for (std::string line; std::getline(stream, line);) words.push_back(line.substr(0, line.find(' ')));
  return words;
}

TEST_F(ListCommandsTest, ListsWhatShipsALineEach) {
  std::vector<std::string> layouts, conditions, controllers;
  for (const DataEntry& entry : list_data(DataKind::layout)) layouts.push_back(entry.name);
  for (const DataEntry& entry : list_data(DataKind::conditions)) conditions.push_back(entry.name);
  for (const servo::Controller& c : servo::controllers()) controllers.emplace_back(c.name);
  EXPECT_EQ(first_words(run({"layouts"}).out), layouts);
  EXPECT_EQ(first_words(run({"conditions"}).out), conditions);
  EXPECT_EQ(first_words(run({"controllers"}).out), controllers);
  EXPECT_THAT(run({"layouts"}).out, HasSubstr("6 columns and 5 rows"));
}

}  // namespace
}  // namespace lineservo::apps
