#include "apps/compare/presets.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "apps/compare/published.h"
#include "apps/flight/mission.h"
#include "tests/apps/test_files.h"

namespace lineservo::apps {
namespace {

using ::testing::AllOf;
using testing::complaint;
using ::testing::HasSubstr;

TEST(Presets, EveryTrackOfEveryPresetHasAPlan) {
  for (const Preset& preset : presets()) {
    for (const Block& block : preset.blocks) {
      for (const std::string& layout : block.layouts) {
        for (const std::string& instruction : block.instructions) {
          FlightRequest request;
          request.layout = layout;
          request.instruction = instruction;
          EXPECT_NO_THROW(prepare(request)) << preset.name << layout << instruction;
        }
      }
    }
  }
}

TEST(Presets, TheSweepOfDeltaHasFiveVariants) {
  const Block& sweep = find_preset("lfpf").blocks.back();
  ASSERT_EQ(sweep.variants.size(), 5u);
  EXPECT_EQ(sweep.variants[0].label, "delta=50");
  EXPECT_EQ(sweep.variants[4].label, "delta=150");
}

TEST(Presets, TheRedTrackIsFlownUnderItsOwnConditions) {
  EXPECT_EQ(find_preset("vtp").conditions, "minidrone");
  EXPECT_EQ(find_preset("topology").conditions, "paper");
}

TEST(Presets, AnUnknownOneIsRefusedWithTheNames) {
  EXPECT_THAT(complaint([] { find_preset("x"); }),
              AllOf(HasSubstr("topology"), HasSubstr("grid-flight, vtp")));
}

TEST(Published, StandsBesideEveryTopologyBlock) {
  for (const Block& block : find_preset("topology").blocks) {
    const auto rows = published_beside(block.title);
    ASSERT_EQ(rows.size(), 1u) << block.title;
    EXPECT_GT(*rows[0].terminal_error_m, 0.13);
  }
  EXPECT_NEAR(*published_beside("a13")[0].rmse_m, std::sqrt(1e-4 + 9e-4), 1e-12);
  EXPECT_EQ(published_beside("straight").size(), 3u);
  EXPECT_TRUE(published_beside("").empty());
}

}  // namespace
}  // namespace lineservo::apps
