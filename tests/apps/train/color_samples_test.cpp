#include "apps/train/color_samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace lineservo::apps {
namespace {

using features::ColorSvm;
using features::LineColor;

TEST(ColorSamples, HalfIsPaintAndTheSeedDecides) {
  const auto samples = color_samples(LineColor::yellow, 200, 7);
  EXPECT_EQ(std::count_if(samples.begin(), samples.end(), [](const auto& s) { return s.is_paint; }), 100);
  const auto again = color_samples(LineColor::yellow, 200, 7),
             other = color_samples(LineColor::yellow, 200, 8);
  const auto same = [](const auto& a, const auto& b) { return a.bgr == b.bgr; };
  EXPECT_TRUE(std::equal(samples.begin(), samples.end(), again.begin(), same));
  EXPECT_FALSE(std::equal(samples.begin(), samples.end(), other.begin(), same));
  EXPECT_THROW(color_samples(LineColor::yellow, 1, 7), std::invalid_argument);
}

TEST(ColorSamples, TheMachineTellsColoursItHasNotSeen) {
  for (const LineColor color : {LineColor::yellow, LineColor::red}) {
    const ColorSvm svm = ColorSvm::trained(color_samples(color, 2000, 1));
    int wrong = 0;
    const auto unseen = color_samples(color, 2000, 2);
    for (const auto& sample : unseen) wrong += int{(svm.decision(sample.bgr) > 0.0) != sample.is_paint};
    EXPECT_LT(wrong, 60) << features::name(color);  // 3 %
  }
}

TEST(ColorSamples, TheShippedModelIsWhatTrainingGives) {
  std::ifstream file(std::filesystem::path(LINESERVO_TEST_DATA) / "models/yellow.yaml", std::ios::binary);
  const std::string shipped{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(ColorSvm::trained(color_samples(LineColor::yellow, 2000, 1)).to_text(), shipped);
}

}  // namespace
}  // namespace lineservo::apps
