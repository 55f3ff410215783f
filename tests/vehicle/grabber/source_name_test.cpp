#include "vehicle/grabber/source_name.h"

#include <gtest/gtest.h>

#include "tests/vehicle/grabber/source_files.h"

namespace lineservo::vehicle {
namespace {

TEST(SourceName, TellsTheKinds) {
  const test::SourceFolder folder;
  folder.write("a%04d.avi", "");
  EXPECT_EQ(source_kind(folder.path()), SourceKind::folder);
  EXPECT_EQ(source_kind(folder.path("f%04d.png")), SourceKind::sequence);
  EXPECT_EQ(source_kind(folder.path("a%04d.avi")), SourceKind::video);  // a file of that very name
  EXPECT_EQ(source_kind(folder.path("none.mp4")), SourceKind::video);
  EXPECT_EQ(source_kind("/dev/video7"), SourceKind::device);
  EXPECT_EQ(source_kind("/dev/null"), SourceKind::device);
  EXPECT_EQ(source_kind("2"), SourceKind::device);
  EXPECT_EQ(source_kind("rtsp://10.0.0.2:554/live"), SourceKind::stream);
  EXPECT_EQ(source_kind("rtspsrc location=rtsp://a/b ! decodebin ! appsink"), SourceKind::pipeline);
}

TEST(SourceName, ANumberIsADevice) {
  EXPECT_EQ(device_path("2"), "/dev/video2");
  EXPECT_EQ(device_path("/dev/v4l/by-id/cam"), "/dev/v4l/by-id/cam");
}

}  // namespace
}  // namespace lineservo::vehicle
