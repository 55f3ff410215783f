#include "vehicle/grabber/steady_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/scripted_source.h"
#include "tests/vehicle/grabber/source_files.h"

namespace lineservo::vehicle {
namespace {

using ::testing::HasSubstr;

cv::Mat image(int width_px) {
  return cv::Mat(48, width_px, CV_8UC3, cv::Scalar::all(9));
}

SteadySource steady(std::vector<cv::Mat> images, const std::string& breaks_off = "") {
  return {std::make_unique<support::ScriptedSource>(std::move(images), breaks_off), "camera"};
}

TEST(SteadySource, PassesFramesOnToTheEnd) {
  SteadySource source = steady({image(64), image(64)});
  EXPECT_EQ(source.format().width_px, 64);
  EXPECT_EQ(source.next()->index, 0);
  const auto second = source.next();
  EXPECT_EQ(second->index, 1);
  EXPECT_EQ(second->stamp, from_seconds(0.1));
  EXPECT_FALSE(source.next());
}

TEST(SteadySource, AChangeOfSizeEndsItAfterTheGoodFrames) {
  SteadySource source = steady({image(64), image(64), image(32)});
  EXPECT_TRUE(source.next());
  EXPECT_TRUE(source.next());
  EXPECT_THAT(test::complaint([&] { source.next(); }),
              HasSubstr("camera: frame 2 is 32×48 px, the source 64×48"));
}

TEST(SteadySource, AStreamThatStopsIsToldAsTheSourceTellsIt) {
  SteadySource source = steady({image(64)}, "camera: the stream stops after 1 frames");
  EXPECT_TRUE(source.next());
  EXPECT_EQ(test::complaint([&] { source.next(); }), "camera: the stream stops after 1 frames");
}

}  // namespace
}  // namespace lineservo::vehicle
