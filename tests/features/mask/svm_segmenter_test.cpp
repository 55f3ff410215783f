#include "features/mask/svm_segmenter.h"

#include <gtest/gtest.h>

namespace lineservo::features {
namespace {

/// Yellows of all lightnesses against greys of all lightnesses.
ColorSvm yellow_against_grey() {
  std::vector<ColorSample> samples;
  for (int v = 80; v <= 250; v += 10) {
    for (int b = 0; b <= 3; ++b) {
      const auto level = [](int value) { return static_cast<std::uint8_t>(value); };
      samples.push_back({{level(v * b / 10), level(v * 17 / 20), level(v)}, true});
      samples.push_back({{level(v - b), level(v), level(v + b)}, false});
    }
  }
  return ColorSvm::trained(samples);
}

TEST(ColorSvm, TellsPaintFromFloor) {
  const ColorSvm svm = yellow_against_grey();
  EXPECT_GT(svm.decision({20, 160, 190}), 0.5);
  EXPECT_LT(svm.decision({150, 150, 150}), -0.5);
}

TEST(ColorSvm, TheSameSamplesGiveTheSameTextAndTheTextTheSameMachine) {
  const ColorSvm svm = yellow_against_grey();
  const std::string text = svm.to_text();
  EXPECT_EQ(yellow_against_grey().to_text(), text);
  const ColorSvm read = ColorSvm::from_text(text);
  for (const cv::Vec3b& color : {cv::Vec3b(20, 160, 190), cv::Vec3b(90, 120, 130), cv::Vec3b(0, 0, 255)})
    EXPECT_DOUBLE_EQ(read.decision(color), svm.decision(color));
}

TEST(ColorSvm, NeedsBothKinds) {
  EXPECT_THROW(ColorSvm::trained({{{0, 255, 255}, true}}), std::invalid_argument);
  EXPECT_THROW(ColorSvm::trained({{{0, 255, 255}, false}}), std::invalid_argument);
  EXPECT_THROW(ColorSvm::from_text(""), std::invalid_argument);
  EXPECT_THROW(ColorSvm::from_text("%YAML:1.0\n---\nother: 1\n"), std::invalid_argument);
}

TEST(SvmSegmenter, GrowsIntoDoubtfulPaintOnlyWhereItTouches) {
  const ColorSvm svm = yellow_against_grey();
  // A pale yellow between the classes; seed and grow lie either side of what the machine says of it.
  const cv::Vec3b pale(120, 168, 184);
  const double of_pale = svm.decision(pale);
  SvmSegmenter segmenter(svm, {.seed = of_pale + 0.2, .grow = of_pale - 0.2});
  cv::Mat picture(32, 64, CV_8UC3, cv::Scalar(150, 150, 150));
  picture(cv::Rect(8, 0, 8, 32)).setTo(cv::Scalar(20, 164, 188));
  picture(cv::Rect(16, 0, 4, 32)).setTo(pale);  // touches the paint
  picture(cv::Rect(40, 0, 8, 32)).setTo(pale);  // does not
  const PackedMask mask = segmenter.segment(picture, {64, 32});
  PackedMask expected(64, 32);
  for (int y = 0; y < 32; ++y)
    for (int x = 8; x < 20; ++x) expected.set(x, y);
  EXPECT_EQ(mask, expected);
  EXPECT_THROW(SvmSegmenter(svm, {.seed = -1.0, .grow = 0.0}), std::invalid_argument);
}

}  // namespace
}  // namespace lineservo::features
