#include "apps/evaluate/degradations.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace lineservo::apps {

void uneven_light(cv::Mat& bgr, double low, double high, vehicle::Random& random) {
  cv::Mat knots(4, 5, CV_32F), gain;
  for (int y = 0; y < knots.rows; ++y)
    for (int x = 0; x < knots.cols; ++x)
      knots.at<float>(y, x) = static_cast<float>(random.uniform(low, high));
  cv::resize(knots, gain, bgr.size(), 0.0, 0.0, cv::INTER_CUBIC);
  for (int y = 0; y < bgr.rows; ++y) {
    const float* g = gain.ptr<float>(y);
    auto* pixel = bgr.ptr<cv::Vec3b>(y);
    for (int x = 0; x < bgr.cols; ++x) {
      const float here = std::clamp(g[x], static_cast<float>(low), static_cast<float>(high));
      for (int c = 0; c < 3; ++c)
        pixel[x][c] = cv::saturate_cast<std::uint8_t>(here * static_cast<float>(pixel[x][c]));
    }
  }
}

void specular_patch(cv::Mat& bgr, double strength, vehicle::Random& random) {
  const double cx = random.uniform(0.0, bgr.cols), cy = random.uniform(0.0, bgr.rows);
  const double radius = random.uniform(0.03, 0.08) * bgr.cols;
  const int reach = static_cast<int>(3.0 * radius);
  const cv::Rect around =
      cv::Rect(static_cast<int>(cx) - reach, static_cast<int>(cy) - reach, 2 * reach, 2 * reach) &
      cv::Rect(0, 0, bgr.cols, bgr.rows);
  for (int y = around.y; y < around.br().y; ++y) {
    auto* pixel = bgr.ptr<cv::Vec3b>(y);
    for (int x = around.x; x < around.br().x; ++x) {
      const double d2 = ((x - cx) * (x - cx) + (y - cy) * (y - cy)) / (radius * radius);
      const double added = strength * std::exp(-0.5 * d2);
      for (int c = 0; c < 3; ++c) pixel[x][c] = cv::saturate_cast<std::uint8_t>(pixel[x][c] + added);
    }
  }
}

void soften(cv::Mat& bgr, double sigma_px) {
  if (sigma_px >= 0.1) cv::GaussianBlur(bgr, bgr, cv::Size(), sigma_px);
}

namespace {

// Dark, grey, bluish or brownish: nothing as saturated and yellow as paint.
cv::Scalar clutter_colour(vehicle::Random& random) {
  const double level = random.uniform(20.0, 200.0);
  return {level * random.uniform(0.8, 1.25), level, level * random.uniform(0.8, 1.15)};
}

void draw_box(cv::Mat& bgr, vehicle::Random& random) {
  const cv::Point2f centre(static_cast<float>(random.uniform(0.0, bgr.cols)),
                           static_cast<float>(random.uniform(0.0, bgr.rows)));
  const cv::Size2f size(static_cast<float>(random.uniform(0.02, 0.1) * bgr.cols),
                        static_cast<float>(random.uniform(0.02, 0.1) * bgr.cols));
  cv::Point2f corners[4];
  cv::RotatedRect(centre, size, static_cast<float>(random.uniform(0.0, 180.0))).points(corners);
  cv::Point fixed[4];
  for (int i = 0; i < 4; ++i) fixed[i] = {cvRound(corners[i].x * 16.0F), cvRound(corners[i].y * 16.0F)};
  cv::fillConvexPoly(bgr, fixed, 4, clutter_colour(random), cv::LINE_AA, 4);
}

void draw_cable(cv::Mat& bgr, vehicle::Random& random) {
  const auto anywhere = [&] {
    return cv::Point(static_cast<int>(random.uniform(0.0, bgr.cols)),
                     static_cast<int>(random.uniform(0.0, bgr.rows)));
  };
  const cv::Point from = anywhere(), to = anywhere();
  const int thickness = 1 + static_cast<int>(random.uniform(0.001, 0.005) * bgr.cols);
  cv::line(bgr, from, to, clutter_colour(random), thickness, cv::LINE_AA);
}

}  // namespace

void clutter(cv::Mat& bgr, int objects, vehicle::Random& random) {
  for (int k = 0; k < objects; ++k) (random.uniform() < 0.7 ? draw_box : draw_cable)(bgr, random);
}

}  // namespace lineservo::apps
