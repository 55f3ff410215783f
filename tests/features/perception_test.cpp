#include "features/perception.h"

#include <gtest/gtest.h>

#include "tests/support/flight_frames.h"
#include "tests/support/stock_segmentation.h"

namespace lineservo::features {
namespace {

using support::FlightFrame;
using support::FlightScene;

constexpr int kFrames = 12;

class OnAFlight : public testing::TestWithParam<FlightScene> {};

TEST_P(OnAFlight, TheMaskIsThatOfTheStockCallsBitForBit) {
  Perception perception(CameraModel(CameraParameters{}), {});
  support::StockSegmentation stock;
  for (const FlightFrame& frame : support::frames_along_a13(GetParam(), kFrames)) {
    perception.observe(frame.bgr, {frame.view, 0.5, 0.1});
    stock.segment(frame.bgr);
    ASSERT_EQ(perception.mask(), PackedMask::from_mat(stock.path));
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, OnAFlight, testing::ValuesIn(support::flight_scenes()),
                         [](const auto& scene) { return scene.param.name; });

}  // namespace
}  // namespace lineservo::features
