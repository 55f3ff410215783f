#include "features/mask/packed_mask.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/support/floor_scenes.h"

namespace lineservo::features {
namespace {

TEST(PackedMask, StartsEmpty) {
  const PackedMask mask(130, 3);
  EXPECT_EQ(mask.width(), 130);
  EXPECT_EQ(mask.height(), 3);
  EXPECT_EQ(mask.words_per_row(), 3);
  EXPECT_EQ(mask.count(), 0);
}

TEST(PackedMask, SetsTheBitOfThePixelAndNoOther) {
  PackedMask mask(130, 3);
  mask.set(65, 1);
  EXPECT_TRUE(mask.at(65, 1));
  EXPECT_EQ(mask.row(1)[1], 2U);
  EXPECT_EQ(mask.count(), 1);
  mask.set(65, 1, false);
  EXPECT_EQ(mask, PackedMask(130, 3));
}

TEST(PackedMask, LastWordPixelsAreThoseWithinTheWidth) {
  EXPECT_EQ(PackedMask(1, 1).last_word_pixels(), 1U);
  EXPECT_EQ(PackedMask(63, 1).last_word_pixels(), ~std::uint64_t{0} >> 1);
  EXPECT_EQ(PackedMask(64, 1).last_word_pixels(), ~std::uint64_t{0});
  EXPECT_EQ(PackedMask(65, 1).last_word_pixels(), 1U);
  EXPECT_EQ(PackedMask(400, 1).last_word_pixels(), 0xFFFFU);
}

TEST(PackedMask, ImageThereAndBack) {
  for (const cv::Size size :
       {cv::Size(1, 1), cv::Size(63, 4), cv::Size(64, 4), cv::Size(65, 4), cv::Size(400, 30)}) {
    const cv::Mat image = support::random_mask(size, 0.4, 5);
    const PackedMask mask = PackedMask::from_mat(image);
    EXPECT_EQ(cv::countNonZero(mask.to_mat() != image), 0);
    EXPECT_EQ(mask.count(), cv::countNonZero(image));
  }
}

TEST(PackedMask, BitsPastTheWidthAreZero) {
  const PackedMask mask = PackedMask::from_mat(cv::Mat(3, 70, CV_8UC1, cv::Scalar(255)));
  for (int y = 0; y < 3; ++y) EXPECT_EQ(mask.row(y)[1], 0x3FU);
}

TEST(PackedMask, AnyValueButZeroIsForeground) {
  const PackedMask mask = PackedMask::from_mat((cv::Mat_<std::uint8_t>(1, 4) << 0, 1, 128, 255));
  EXPECT_EQ(mask.row(0)[0], 0b1110U);
}

TEST(PackedMask, RefusesBadSizesAndTypes) {
  EXPECT_THROW(PackedMask(0, 4), std::invalid_argument);
  EXPECT_THROW(PackedMask(4, -1), std::invalid_argument);
  EXPECT_THROW(PackedMask(65536, 4), std::invalid_argument);
  EXPECT_THROW(PackedMask::from_mat(cv::Mat::zeros(4, 4, CV_8UC3)), std::invalid_argument);
  EXPECT_THROW(PackedMask::from_mat(cv::Mat()), std::invalid_argument);
}

}  // namespace
}  // namespace lineservo::features
