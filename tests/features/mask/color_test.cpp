// The colour tests over all 2²⁴ colours, against OpenCV.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "features/mask/color_classes.h"
#include "features/mask/frame_classifier.h"
#include "features/mask/red_sector_test.h"
#include "tests/support/stock_segmentation.h"

namespace lineservo::features {
namespace {

using lineservo::support::StockSegmentation;

constexpr int kSide = 256;

// All greens and reds at one blue.
cv::Mat colors_of(int blue) {
  cv::Mat image(kSide, kSide, CV_8UC3);
  for (int g = 0; g < kSide; ++g)
    for (int r = 0; r < kSide; ++r)
      image.at<cv::Vec3b>(g, r) = {static_cast<std::uint8_t>(blue), static_cast<std::uint8_t>(g),
                                   static_cast<std::uint8_t>(r)};
  return image;
}

SegmenterOptions unscaled(SegmenterOptions options = {}) {
  options.width_px = options.height_px = kSide;
  return options;
}

// Calls check(blue, reference) with the stock classification of each of the 256 images.
template <typename Check>
void for_all_colors(const SegmenterOptions& options, Check check) {
  StockSegmentation stock(options);
  for (int blue = 0; blue < 256; ++blue) {
    const cv::Mat image = colors_of(blue);
    stock.resize(image);
    stock.classify();
    check(blue, image, stock);
  }
}

TEST(Hsv, AllColorsAreThoseOfCvtColor) {
  cv::Mat hsv;
  for (int b = 0; b < 256; ++b) {
    cv::cvtColor(colors_of(b), hsv, cv::COLOR_BGR2HSV);
    int differences = 0;
    for (int g = 0; g < kSide; ++g) {
      for (int r = 0; r < kSide; ++r) {
        const Hsv ours = hsv_of(b, g, r);
        const auto& stock = hsv.at<cv::Vec3b>(g, r);
        differences += ours.h != stock[0] || ours.s != stock[1] || ours.v != stock[2];
      }
    }
    ASSERT_EQ(differences, 0) << "blue " << b;
  }
}

// The published bounds, and those on hue and chroma alone.
class AllColors : public testing::TestWithParam<SegmenterOptions> {};
INSTANTIATE_TEST_SUITE_P(Both, AllColors, testing::Values(unscaled(), unscaled(any_light_ranges())));

TEST_P(AllColors, RedSectorTestEqualsInRange) {
  const auto test = make_red_sector_test(GetParam());
  ASSERT_TRUE(test.has_value());
  for_all_colors(GetParam(), [&](int b, const cv::Mat&, const StockSegmentation& stock) {
    int differences = 0;
    for (int g = 0; g < kSide; ++g) {
      for (int r = 0; r < kSide; ++r) {
        differences += test->path.accepts(b, g, r) != (stock.colored.at<std::uint8_t>(g, r) != 0);
        differences += test->marker.accepts(b, g, r) != (stock.marker.at<std::uint8_t>(g, r) != 0);
      }
    }
    ASSERT_EQ(differences, 0) << "blue " << b;
  });
}

TEST_P(AllColors, ClassifiersEqualInRange) {
  for (const Processor processor :
       {Processor::portable, std::min(Processor::avx2, best_processor()), best_processor()}) {
    const auto classifier = make_classifier(GetParam(), {kSide, kSide}, processor);
    PackedMask path(kSide, kSide), marker(kSide, kSide);
    for_all_colors(GetParam(), [&](int b, const cv::Mat& image, const StockSegmentation& stock) {
      ASSERT_EQ(classifier->classify(image, path, marker), stock.marker_pixels) << "blue " << b;
      ASSERT_EQ(path, PackedMask::from_mat(stock.colored)) << "blue " << b;
      ASSERT_EQ(marker, PackedMask::from_mat(stock.marker)) << "blue " << b;
    });
  }
}

// The printed upper hue of yellow lets the reds of 170 to 175 pass, and nothing between 176 and 17.
TEST(ColorClasses, PrintedYellowAdmitsTheRedsAbove170) {
  const ColorClasses classes{SegmenterOptions{}};
  EXPECT_TRUE(classes.of_hue(18) & kPath);
  EXPECT_FALSE(classes.of_hue(17) & kPath);
  EXPECT_TRUE(classes.of_hue(175) & kPath);
  EXPECT_FALSE(classes.of_hue(176) & kPath);
  EXPECT_TRUE(classes.of_hue(175) & kMarker);
  EXPECT_FALSE(classes.of_hue(169) & kMarker);
  EXPECT_FALSE(classes.of_hue(11) & kMarker);
  EXPECT_EQ(classes.of(0, 200, 255), kPath);               // yellow, hue 24
  EXPECT_EQ(classes.of(0, 0, 255), kMarkerLow);            // hue 0
  EXPECT_EQ(classes.of(64, 0, 255), kPath | kMarkerHigh);  // hue 172
  EXPECT_EQ(classes.of(128, 128, 128), 0);
}

TEST(RedSectorTest, KnowsWhichBoundsItCannotWrite) {
  EXPECT_TRUE(make_red_sector_test({}).has_value());
  SegmenterOptions green_bound;
  green_bound.path.h_max = 60;
  EXPECT_FALSE(make_red_sector_test(green_bound).has_value());
  SegmenterOptions dark;
  dark.path.v_max = 254;
  EXPECT_FALSE(make_red_sector_test(dark).has_value());
  SegmenterOptions unequal;
  unequal.marker[0].s_min = 99;
  EXPECT_FALSE(make_red_sector_test(unequal).has_value());
}

}  // namespace
}  // namespace lineservo::features
