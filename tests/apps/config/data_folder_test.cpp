#include "apps/config/data_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "apps/config/flight_request.h"
#include "tests/apps/test_files.h"

namespace lineservo::apps {
namespace {

using ::testing::AllOf;
using testing::complaint;
using ::testing::HasSubstr;
using testing::TempFolder;

std::vector<std::string> names(DataKind kind) {
  std::vector<std::string> list;
  for (const DataEntry& entry : list_data(kind)) list.push_back(entry.name);
  return list;
}

/// LINESERVO_DATA set to something else for a while.
class OtherData {
 public:
  explicit OtherData(const std::string& folder) { ::setenv("LINESERVO_DATA", folder.c_str(), 1); }
  ~OtherData() { ::setenv("LINESERVO_DATA", LINESERVO_TEST_DATA, 1); }
};

TEST(FindData, FindsWhatShipsByItsName) {
  EXPECT_EQ(find_data(DataKind::layout, "warehouse"),
            std::filesystem::path(LINESERVO_TEST_DATA) / "layouts/warehouse.yaml");
  EXPECT_EQ(find_data(DataKind::conditions, "paper"),
            std::filesystem::path(LINESERVO_TEST_DATA) / "conditions/paper.yaml");
}

// Else a slow flight under a biased velocity takes the next node for the one after it.
TEST(ShippedConditions, TheDeadReckoningIsTrustedToThreeTimesTheVelocityBias) {
  for (const std::string& name : names(DataKind::conditions)) {
    FlightRequest request;
    apply_conditions(request, name);
    EXPECT_GE(request.settings.executive.phases.odometry_drift_m_s + 1e-12,
              3.0 * request.settings.sensors.velocity_bias_m_s)
        << name;
  }
}

TEST(FindData, TakesAFileOfOnesOwnByItsPath) {
  const TempFolder folder;
  const std::filesystem::path file = folder.write("mine.yaml", "name: x\n");
  EXPECT_EQ(find_data(DataKind::layout, file.string()), file);
}

TEST(FindData, NamesWhatThereIsWhenItFindsNothing) {
  EXPECT_THAT(complaint([] { find_data(DataKind::layout, "warehose"); }),
              AllOf(HasSubstr("no layout 'warehose'"), HasSubstr("bend"), HasSubstr("straight"),
                    HasSubstr("tape-warehouse"), HasSubstr("warehouse")));
  EXPECT_THAT(complaint([] { find_data(DataKind::conditions, "warehouse"); }),
              AllOf(HasSubstr("no conditions 'warehouse'"), HasSubstr("ideal"), HasSubstr("paper")));
}

TEST(FindData, AFolderAndNothingAreNoFiles) {
  EXPECT_THAT(complaint([] { find_data(DataKind::layout, "/"); }), HasSubstr("no layout '/'"));
  EXPECT_THAT(complaint([] { find_data(DataKind::layout, ""); }), HasSubstr("no layout ''"));
}

TEST(FindData, ADataFolderThatIsNoneIsBadInput) {
  const TempFolder folder;
  const OtherData other(folder.path() / "nothing");
  EXPECT_THAT(complaint([] { find_data(DataKind::layout, "warehouse"); }), HasSubstr("LINESERVO_DATA"));
  EXPECT_THAT(complaint([] { list_data(DataKind::conditions); }), HasSubstr("LINESERVO_DATA"));
}

TEST(ListData, IsInOrderOfNamesAndEachHasADescription) {
  for (const DataKind kind : {DataKind::layout, DataKind::conditions}) {
    const std::vector<std::string> list = names(kind);
    EXPECT_TRUE(std::is_sorted(list.begin(), list.end()));
    for (const DataEntry& entry : list_data(kind)) EXPECT_FALSE(entry.description.empty()) << entry.name;
  }
  EXPECT_THAT(names(DataKind::layout),
              ::testing::IsSupersetOf({"bend", "straight", "tape-warehouse", "warehouse"}));
  EXPECT_THAT(names(DataKind::conditions), ::testing::IsSupersetOf({"ideal", "paper", "harsh"}));
}

TEST(ListData, PassesOverWhatIsNotYaml) {
  const TempFolder folder;
  std::filesystem::create_directories(folder.path() / "layouts");
  folder.write("layouts/b.yaml", "description: second\n");
  folder.write("layouts/a.yaml", "description: first\n");
  folder.write("layouts/notes.txt", "x\n");
  const OtherData other(folder.path());
  const std::vector<DataEntry> entries = list_data(DataKind::layout);
  ASSERT_EQ(entries.size(), 2u);
  EXPECT_EQ(entries[0].name + " " + entries[0].description, "a first");
  EXPECT_EQ(entries[1].name + " " + entries[1].description, "b second");
}

}  // namespace
}  // namespace lineservo::apps
