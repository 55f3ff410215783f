#include "features/mask/path_segmenter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "features/junction/fpd.h"
#include "tests/support/floor_scenes.h"
#include "tests/support/stock_segmentation.h"

namespace lineservo::features {
namespace {

using lineservo::support::floor_scene;
using lineservo::support::random_image;
using lineservo::support::StockSegmentation;

const cv::Scalar kYellow(20, 205, 225);
const cv::Scalar kRed(30, 25, 200);

void expect_same_as_stock(const cv::Mat& frame, PathSegmenter& segmenter) {
  StockSegmentation stock(segmenter.options());
  stock.segment(frame);
  const Segmentation& ours = segmenter.segment(frame);
  EXPECT_EQ(ours.marker_pixels, stock.marker_pixels);
  EXPECT_EQ(ours.path, PackedMask::from_mat(stock.path));
}

// Every test runs on all sets of instructions; one that is missing here repeats the best that there is.
class OnProcessor : public testing::TestWithParam<Processor> {
 protected:
  void SetUp() override { processor = std::min(GetParam(), best_processor()); }
  Processor processor = Processor::portable;
};

std::string processor_name(const testing::TestParamInfo<Processor>& info) {
  return info.param == Processor::avx512 ? "Avx512" : info.param == Processor::avx2 ? "Avx2" : "Portable";
}

INSTANTIATE_TEST_SUITE_P(All, OnProcessor,
                         testing::Values(Processor::portable, Processor::avx2, Processor::avx512),
                         processor_name);

const std::array<cv::Size, 12> kFrameSizes = {{{640, 480},
                                               {1920, 1080},
                                               {641, 479},
                                               {320, 240},
                                               {400, 400},
                                               {800, 800},
                                               {1200, 1200},
                                               {1201, 401},
                                               {160, 120},
                                               {16, 16},
                                               {17, 2000},
                                               {4096, 31}}};

TEST_P(OnProcessor, EqualsStockOnRandomFramesOfEverySize) {
  PathSegmenter segmenter({}, processor);
  for (const cv::Size size : kFrameSizes) {
    SCOPED_TRACE(std::to_string(size.width) + "x" + std::to_string(size.height));
    expect_same_as_stock(random_image(size, CV_8UC3, 7), segmenter);
  }
}

TEST_P(OnProcessor, EqualsStockOnFloorScenesWithNoise) {
  PathSegmenter segmenter({}, processor);
  for (const cv::Size size : kFrameSizes) {
    for (const double sigma : {0.0, 2.0, 12.0, 40.0}) {
      SCOPED_TRACE(std::to_string(size.width) + "x" + std::to_string(size.height) + " sigma " +
                   std::to_string(sigma));
      expect_same_as_stock(floor_scene(size, 11.0 + sigma, sigma), segmenter);
    }
  }
}

TEST_P(OnProcessor, EqualsStockOnManyRandomFrames) {
  PathSegmenter segmenter({}, processor);
  for (std::uint64_t seed = 100; seed < 112; ++seed)
    expect_same_as_stock(random_image({640, 480}, CV_8UC3, seed), segmenter);
}

TEST_P(OnProcessor, EqualsStockForOtherResizedSizes) {
  for (const cv::Size size :
       {cv::Size(16, 16), cv::Size(63, 65), cv::Size(64, 40), cv::Size(129, 97), cv::Size(321, 240)}) {
    SegmenterOptions options;
    options.width_px = size.width;
    options.height_px = size.height;
    PathSegmenter segmenter(options, processor);
    SCOPED_TRACE(size.width);
    expect_same_as_stock(random_image({640, 480}, CV_8UC3, 3), segmenter);
    expect_same_as_stock(floor_scene({320, 240}, 20.0, 6.0), segmenter);
  }
}

TEST_P(OnProcessor, EqualsStockForOtherColors) {
  SegmenterOptions green;
  green.path = {35, 85, 40, 250, 30, 245};
  SegmenterOptions everything;
  everything.path = {};
  SegmenterOptions nothing_saturated;
  nothing_saturated.path = {0, 180, 0, 30, 200, 255};
  SegmenterOptions narrow_yellow;
  narrow_yellow.path = {20, 35, 80, 255, 80, 255};
  SegmenterOptions strict;
  strict.path = {25, 176, 120, 255, 60, 255};
  strict.marker = {HsvBounds{0, 5, 30, 255, 20, 255}, HsvBounds{165, 180, 30, 255, 20, 255}};
  SegmenterOptions saturated_chroma = strict;
  saturated_chroma.path.c_min = 60;
  for (const SegmenterOptions& options :
       {green, everything, nothing_saturated, narrow_yellow, strict, any_light_ranges(), saturated_chroma}) {
    PathSegmenter segmenter(options, processor);
    SCOPED_TRACE(options.path.h_min);
    expect_same_as_stock(random_image({640, 480}, CV_8UC3, 5), segmenter);
    expect_same_as_stock(floor_scene({640, 480}, -30.0, 25.0), segmenter);
  }
}

// Paint keeps its mask where 0.4 of the light is left, and where the glare of a lamp adds 180 levels of
// white; the published bounds on V and S lose it there.
TEST_P(OnProcessor, AnyLightKeepsThePaint) {
  for (const auto& [factor, glare] :
       {std::pair{1.0, 0.0}, {0.4, 0.0}, {1.3, 0.0}, {0.4, 180.0}, {1.0, 180.0}}) {
    cv::Mat frame(480, 640, CV_8UC3, cv::Scalar::all(120.0 * factor + glare));
    const auto lit = [factor = factor, glare = glare](double b, double g, double r) {
      return cv::Scalar(b * factor + glare, g * factor + glare, r * factor + glare);
    };
    frame.colRange(160, 320).setTo(lit(0, 200, 230));
    frame.colRange(480, 640).setTo(lit(40, 40, 220));
    PathSegmenter segmenter(any_light_ranges(), processor), published({}, processor);
    SCOPED_TRACE(std::to_string(factor) + " " + std::to_string(glare));
    EXPECT_EQ(segmenter.segment(frame).path.count(), 100 * 400);
    EXPECT_EQ(segmenter.segment(frame).marker_pixels, 100 * 400);
    const bool is_plain = factor >= 1.0 && glare == 0.0;
    EXPECT_EQ(published.segment(frame).path.count() == 100 * 400, is_plain);
  }
}

TEST_P(OnProcessor, AnyLightLeavesNoisyAndDirtyFloorBare) {
  for (const double grey : {30.0, 48.0, 120.0, 240.0}) {
    cv::Mat frame(480, 640, CV_8UC3), noise(480, 640, CV_16SC3);
    frame.setTo(cv::Scalar(grey - 6.0, grey - 2.0, grey + 4.0));  // brownish, as dirt
    cv::RNG(3).fill(noise, cv::RNG::NORMAL, 0.0, 6.0);
    cv::add(frame, noise, frame, cv::noArray(), CV_8UC3);
    PathSegmenter segmenter(any_light_ranges(), processor);
    EXPECT_EQ(segmenter.segment(frame).path.count(), 0) << grey;
    EXPECT_LT(segmenter.segment(frame).marker_pixels, kStartMarkerLimit_px / 2) << grey;
  }
}

TEST_P(OnProcessor, AllYellowIsAllPath) {
  PathSegmenter segmenter({}, processor);
  const Segmentation& result = segmenter.segment(cv::Mat(480, 640, CV_8UC3, kYellow));
  EXPECT_EQ(result.path.count(), 400 * 400);
  EXPECT_EQ(result.marker_pixels, 0);
}

TEST_P(OnProcessor, AllBlackIsNothing) {
  PathSegmenter segmenter({}, processor);
  const Segmentation& result = segmenter.segment(cv::Mat::zeros(480, 640, CV_8UC3));
  EXPECT_EQ(result.path.count(), 0);
  EXPECT_EQ(result.marker_pixels, 0);
}

TEST_P(OnProcessor, AllRedIsAllMarker) {
  PathSegmenter segmenter({}, processor);
  EXPECT_EQ(segmenter.segment(cv::Mat(480, 640, CV_8UC3, kRed)).marker_pixels, 400 * 400);
}

// 160 of 640 columns are 100 of 400: a bar at the border keeps its width, one inside too.
TEST_P(OnProcessor, AYellowBarMapsToItsShareOfTheFrame) {
  for (const int left : {0, 240, 480}) {
    cv::Mat frame(480, 640, CV_8UC3, cv::Scalar::all(90));
    frame.colRange(left, left + 160).setTo(kYellow);
    PathSegmenter segmenter({}, processor);
    const PackedMask& path = segmenter.segment(frame).path;
    EXPECT_EQ(path.count(), 100 * 400);
    for (int x = 0; x < 400; ++x)
      EXPECT_EQ(path.at(x, 200), x >= left * 5 / 8 && x < left * 5 / 8 + 100) << x;
  }
}

TEST_P(OnProcessor, AFrameInsideALargerImageIsReadByItsOwnRows) {
  PathSegmenter segmenter({}, processor);
  const cv::Mat whole = floor_scene({701, 555}, 33.0, 8.0);
  const cv::Mat part = whole(cv::Rect(37, 21, 643, 481));
  expect_same_as_stock(part, segmenter);
}

// Both frames would read one byte too far on a wrong gather at the end of the last row.
TEST_P(OnProcessor, NothingIsReadPastTheLastPixel) {
  for (const cv::Size size : {cv::Size(640, 480), cv::Size(2000, 20), cv::Size(16, 16)}) {
    const auto bytes = static_cast<std::size_t>(size.area()) * 3;
    const std::unique_ptr<std::uint8_t[]> exact(new std::uint8_t[bytes]);
    cv::Mat frame(size, CV_8UC3, exact.get());
    random_image(size, CV_8UC3, 9).copyTo(frame);
    PathSegmenter segmenter({}, processor);
    expect_same_as_stock(frame, segmenter);
  }
}

TEST(PathSegmenter, AFrameTellsNothingOfTheOneBefore) {
  PathSegmenter used, fresh;
  const cv::Mat frame = floor_scene({640, 480}, 5.0, 4.0);
  used.segment(random_image({640, 480}, CV_8UC3, 1));
  used.segment(random_image({320, 240}, CV_8UC3, 2));
  EXPECT_EQ(used.segment(frame).path, fresh.segment(frame).path);
}

TEST(PathSegmenter, RefusesWhatIsNoColorFrame) {
  PathSegmenter segmenter;
  EXPECT_THROW(segmenter.segment(cv::Mat()), std::invalid_argument);
  EXPECT_THROW(segmenter.segment(cv::Mat::zeros(480, 640, CV_8UC1)), std::invalid_argument);
  EXPECT_THROW(segmenter.segment(cv::Mat::zeros(480, 640, CV_8UC4)), std::invalid_argument);
  EXPECT_THROW(segmenter.segment(cv::Mat::zeros(480, 640, CV_16UC3)), std::invalid_argument);
  EXPECT_THROW(segmenter.segment(cv::Mat::zeros(15, 640, CV_8UC3)), std::invalid_argument);
  EXPECT_THROW(segmenter.segment(cv::Mat::zeros(480, 15, CV_8UC3)), std::invalid_argument);
  EXPECT_NO_THROW(segmenter.segment(cv::Mat::zeros(16, 16, CV_8UC3)));
}

TEST(PathSegmenter, NamesEveryBadOptionAtOnce) {
  SegmenterOptions options;
  options.width_px = 8;
  options.path.h_max = 181;
  options.marker[1].s_min = 256;
  options.path.c_min = -1;
  try {
    PathSegmenter segmenter(options);
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    const std::string what = error.what();
    EXPECT_NE(what.find("width must be 16 to 4096"), std::string::npos) << what;
    EXPECT_NE(what.find("path hue must hold 0 <= min <= max <= 180, got 18 to 181"), std::string::npos)
        << what;
    EXPECT_NE(what.find("path chroma"), std::string::npos) << what;
    EXPECT_NE(what.find("marker saturation"), std::string::npos) << what;
  }
}

}  // namespace
}  // namespace lineservo::features
