#include "apps/watch/sim_feed.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/recording/digest.h"
#include "apps/watch/recording_feed.h"
#include "apps/watch/watch.h"
#include "tests/apps/recording/recorded_flight.h"

namespace lineservo::apps {
namespace {

using ::testing::HasSubstr;

/// Digests of what the chain sees, tick by tick, until the feed ends.
std::vector<std::string> seen(WatchFeed& feed, const FlightRequest& request, std::size_t ticks) {
  WatchChains chains(feed.camera(), request.settings, {request.controller});
  std::vector<std::string> digests;
  while (digests.size() < ticks) {
    const auto tick = feed.next();
    if (!tick) break;
    digests.push_back(digest(chains.look(*tick).outputs.front().features));
  }
  return digests;
}

std::vector<std::string> recorded(const Recording& recording) {
  std::vector<std::string> digests;
  for (const RecordedTick& tick : recording.ticks) digests.push_back(tick.outputs.front().features_sha256);
  return digests;
}

TEST(SimFeed, AndARecordingShowTheFeaturesThatTheFlightHad) {
  const FlightRequest request = testing::short_request();
  const testing::TempFolder temp;
  testing::record_flight(temp.path(), request);
  const Recording recording = read_recording(temp.path());
  const std::vector<std::string> flown = recorded(recording);
  RecordingFeed again(recording);
  EXPECT_EQ(seen(again, request, flown.size()), flown);
  EXPECT_FALSE(again.next());
  SimFeed sim(prepare(request));
  EXPECT_EQ(seen(sim, request, flown.size()), flown);
}

TEST(SimFeed, IsNamedByItsFloorAndTarget) {
  EXPECT_FALSE(sim_source("video.mp4"));
  EXPECT_EQ(sim_source("sim:tape-warehouse/a13")->layout, "tape-warehouse");
  EXPECT_EQ(sim_source("sim:tape-warehouse/a13")->target, "a13");
  EXPECT_EQ(sim_source("sim:my/floor.yaml/node:q")->layout, "my/floor.yaml");
  EXPECT_EQ(sim_source("sim:b02")->layout, "square");
  for (const char* name : {"sim:", "sim:warehouse/", "sim:/a13"})
    EXPECT_THAT(testing::complaint([&] { sim_source(name); }), HasSubstr("must be sim:LAYOUT/TARGET"));
}

}  // namespace
}  // namespace lineservo::apps
