#include "features/mask/mask_profile.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "tests/support/floor_scenes.h"

namespace lineservo::features {
namespace {

PackedMask rectangle(int width, int height, cv::Rect area) {
  cv::Mat image = cv::Mat::zeros(height, width, CV_8UC1);
  image(area).setTo(255);
  return PackedMask::from_mat(image);
}

TEST(MaskProfile, CountsOfARectangle) {
  const MaskProfile profile = profile_of(rectangle(400, 300, {60, 40, 70, 90}));
  EXPECT_EQ(profile.foreground, 70 * 90);
  for (int x = 0; x < 400; ++x)
    EXPECT_EQ(profile.columns[static_cast<std::size_t>(x)], x >= 60 && x < 130 ? 90 : 0);
  for (int y = 0; y < 300; ++y)
    EXPECT_EQ(profile.rows[static_cast<std::size_t>(y)], y >= 40 && y < 130 ? 70 : 0);
}

TEST(MaskProfile, CountsOfRandomMasksEqualOpenCvSums) {
  for (const cv::Size size : {cv::Size(1, 1), cv::Size(64, 3), cv::Size(65, 128), cv::Size(401, 399)}) {
    const cv::Mat image = support::random_mask(size, 0.5, 8);
    const MaskProfile profile = profile_of(PackedMask::from_mat(image));
    cv::Mat columns, rows;
    cv::reduce(image / 255, columns, 0, cv::REDUCE_SUM, CV_32S);
    cv::reduce(image / 255, rows, 1, cv::REDUCE_SUM, CV_32S);
    EXPECT_TRUE(
        std::equal(profile.columns.begin(), profile.columns.end(), columns.begin<int>(), columns.end<int>()));
    EXPECT_TRUE(std::equal(profile.rows.begin(), profile.rows.end(), rows.begin<int>(), rows.end<int>()));
    EXPECT_EQ(profile.foreground, cv::countNonZero(image));
  }
}

TEST(MaskProfile, CountsUpToTheFullHeight) {
  const MaskProfile profile = profile_of(rectangle(3, 5001, {0, 0, 3, 5001}));
  EXPECT_EQ(profile.columns, (std::vector<int>{5001, 5001, 5001}));
}

TEST(MaskProfile, ReusedMemoryHoldsNothingOld) {
  MaskProfile profile = profile_of(rectangle(400, 400, {0, 0, 400, 400}));
  profile_of(rectangle(100, 50, {10, 10, 5, 5}), profile);
  EXPECT_EQ(profile.columns, profile_of(rectangle(100, 50, {10, 10, 5, 5})).columns);
  EXPECT_EQ(profile.foreground, 25);
}

// Pixels x … x + w − 1 have their mean at x + (w − 1) / 2.
TEST(Centroid, OfARectangleIsItsMiddle) {
  const auto middle = centroid(profile_of(rectangle(400, 400, {60, 40, 70, 91})));
  ASSERT_TRUE(middle.has_value());
  EXPECT_DOUBLE_EQ(middle->x, 60 + 34.5);
  EXPECT_DOUBLE_EQ(middle->y, 40 + 45.0);
}

TEST(Centroid, EqualsTheMomentsOfTheImage) {
  const cv::Mat image = support::random_mask({333, 222}, 0.2, 21);
  const cv::Moments moments = cv::moments(image, true);
  const auto middle = centroid(profile_of(PackedMask::from_mat(image)));
  ASSERT_TRUE(middle.has_value());
  EXPECT_NEAR(middle->x, moments.m10 / moments.m00, 1e-9);
  EXPECT_NEAR(middle->y, moments.m01 / moments.m00, 1e-9);
}

TEST(Centroid, OfNothingIsAbsent) {
  EXPECT_FALSE(centroid(profile_of(PackedMask(400, 400))).has_value());
}

TEST(ForegroundRatio, IsTheShareOfTheArea) {
  EXPECT_DOUBLE_EQ(foreground_ratio(profile_of(rectangle(400, 400, {0, 0, 100, 400}))), 0.25);
  EXPECT_DOUBLE_EQ(foreground_ratio(profile_of(PackedMask(400, 400))), 0.0);
  EXPECT_DOUBLE_EQ(foreground_ratio(profile_of(rectangle(70, 3, {0, 0, 70, 3}))), 1.0);
}

}  // namespace
}  // namespace lineservo::features
