#include "features/line/edge_gauge.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "tests/features/line/drawn_stripe.h"

namespace lineservo::features {
namespace {

using test::draw_image;
using test::stripe_through;

const Eigen::Vector3d kYellowLessGrey(-110.0, 78.0, 112.0);

TEST(EdgeGauge, LocatesAnUprightEdgeAtAnySubPixelPlace) {
  for (double shift = 0.0; shift < 1.0; shift += 0.1) {
    const cv::Mat image = draw_image({100, 40}, {{60.0 + shift, 0.0, 40.0}});  // paint from 40 + shift on
    const EdgeGauge gauge(image, kYellowLessGrey);
    const auto offset = gauge.locate({41.0, 20.0}, {1.0, 0.0}, 6);
    ASSERT_TRUE(offset);
    EXPECT_NEAR(*offset, shift - 1.0, 0.01);
  }
}

TEST(EdgeGauge, ABlurDoesNotMoveTheEdge) {
  cv::Mat image = draw_image({100, 40}, {{60.3, 0.0, 40.0}});
  cv::GaussianBlur(image, image, cv::Size(), 1.5);
  const auto offset = EdgeGauge(image, kYellowLessGrey).locate({40.3, 20.0}, {1.0, 0.0}, 7);
  ASSERT_TRUE(offset);
  EXPECT_NEAR(*offset, 0.0, 0.03);
}

TEST(EdgeGauge, AnObliqueEdgeAlongItsNormal) {
  const test::DrawnStripe stripe = stripe_through(60.0, 40.0, 30.0, 30.0);
  const cv::Mat image = draw_image({120, 80}, {stripe});
  const Eigen::Vector2d n(std::cos(stripe.theta_rad), std::sin(stripe.theta_rad));
  for (double shift = -1.0; shift <= 1.0; shift += 0.25) {
    const Eigen::Vector2d at = Eigen::Vector2d(60.0, 40.0) - (15.0 + shift) * n;
    const auto offset = EdgeGauge(image, kYellowLessGrey).locate({at.x(), at.y()}, n, 5);
    ASSERT_TRUE(offset);
    EXPECT_NEAR(*offset, shift, 0.05);
  }
}

TEST(EdgeGauge, NoneWhereThereIsNoEdgeOrItFallsTheOtherWay) {
  const cv::Mat image = draw_image({100, 40}, {{60.0, 0.0, 40.0}});
  const EdgeGauge gauge(image, kYellowLessGrey);
  EXPECT_FALSE(gauge.locate({20.0, 20.0}, {1.0, 0.0}, 5));
  EXPECT_FALSE(gauge.locate({60.0, 20.0}, {1.0, 0.0}, 5));
  EXPECT_FALSE(gauge.locate({40.0, 20.0}, {-1.0, 0.0}, 5));
  EXPECT_TRUE(gauge.locate({80.0, 20.0}, {-1.0, 0.0}, 5));
}

TEST(EdgeGauge, NoneWhereTheProfileLeavesTheImage) {
  const cv::Mat image = draw_image({100, 40}, {{10.0, 0.0, 14.0}});
  const EdgeGauge gauge(image, kYellowLessGrey);
  EXPECT_FALSE(gauge.locate({3.0, 20.0}, {1.0, 0.0}, 4));
  EXPECT_TRUE(gauge.locate({3.0, 20.0}, {1.0, 0.0}, 3));
}

TEST(EdgeGauge, OneChannelWillDo) {
  cv::Mat grey;
  cv::cvtColor(draw_image({100, 40}, {{60.4, 0.0, 40.0}}), grey, cv::COLOR_BGR2GRAY);
  const auto offset = EdgeGauge(grey, {70.0, 0.0, 0.0}).locate({40.0, 20.0}, {1.0, 0.0}, 5);
  ASSERT_TRUE(offset);
  EXPECT_NEAR(*offset, 0.4, 0.02);
}

}  // namespace
}  // namespace lineservo::features
