#include "apps/grabber/load_grabbers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include "apps/image/image_file.h"
#include "tests/apps/test_files.h"

namespace lineservo::apps {
namespace {

using ::testing::HasSubstr;

// What the module throws is caught by its type here.
TEST(LoadGrabbers, FramesAndComplaintsComeOutOfTheModule) {
  const testing::TempFolder temp;
  const cv::Mat image(48, 64, CV_8UC3, cv::Scalar(10, 20, 30));
  temp.write("a.png", png_bytes(image));
  temp.write("b.png", "no image");
  const auto source = load_source(temp.path().string(), {});
  EXPECT_EQ(source->format().width_px, 64);
  EXPECT_EQ(cv::norm(source->next()->bgr, image, cv::NORM_INF), 0.0);
  EXPECT_THROW(source->next(), vehicle::GrabberError);
}

TEST(LoadGrabbers, ASourceThatIsNotThereIsBadInput) {
  EXPECT_THAT(testing::complaint([] { load_source("/dev/no-camera", {}); }), HasSubstr("cannot be opened"));
}

}  // namespace
}  // namespace lineservo::apps
