#pragma once

#include <cmath>
#include <opencv2/imgproc.hpp>

namespace lineservo::support {

/// A frame as the down camera sees it: a yellow cross on a grey floor, turned by an angle, with a red disc,
/// uneven light and pixel noise. Deterministic.
inline cv::Mat floor_scene(cv::Size size, double angle_deg, double noise_sigma, std::uint64_t seed = 1) {
  cv::Mat image(size, CV_8UC3, cv::Scalar(128, 132, 130));
  const cv::Point2f centre(0.55F * static_cast<float>(size.width), 0.45F * static_cast<float>(size.height));
  const auto width = static_cast<float>(size.width);
  const auto band = [&](double turn_deg, float thickness) {
    cv::Point2f corners[4];
    cv::RotatedRect(centre, {3.0F * width, thickness}, static_cast<float>(angle_deg + turn_deg))
        .points(corners);
    cv::Point fixed[4];
    for (int i = 0; i < 4; ++i) fixed[i] = {cvRound(corners[i].x * 16.0F), cvRound(corners[i].y * 16.0F)};
    cv::fillConvexPoly(image, fixed, 4, cv::Scalar(20, 205, 225), cv::LINE_AA, 4);
  };
  band(90.0, 0.22F * width);
  band(0.0, 0.10F * width);
  cv::circle(image, {size.width / 3, size.height * 3 / 4}, size.width / 12, cv::Scalar(30, 25, 200),
             cv::FILLED, cv::LINE_AA);
  cv::Mat light(size, CV_32FC3), bright;
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x)
      light.at<cv::Vec3f>(y, x) = cv::Vec3f::all(0.7F + 0.5F * static_cast<float>(x + y) /
                                                            static_cast<float>(size.width + size.height));
  image.convertTo(bright, CV_32FC3);
  cv::Mat noise(size, CV_32FC3);
  cv::RNG(seed).fill(noise, cv::RNG::NORMAL, 0.0, noise_sigma);
  bright = bright.mul(light) + noise;
  bright.convertTo(image, CV_8UC3);
  return image;
}

/// Every byte drawn by itself.
inline cv::Mat random_image(cv::Size size, int type, std::uint64_t seed) {
  cv::Mat image(size, type);
  cv::RNG(seed).fill(image, cv::RNG::UNIFORM, 0, 256);
  return image;
}

/// 255 with the given probability, else 0.
inline cv::Mat random_mask(cv::Size size, double density, std::uint64_t seed) {
  cv::Mat values(size, CV_32FC1);
  cv::RNG(seed).fill(values, cv::RNG::UNIFORM, 0.0, 1.0);
  return values < density;
}

}  // namespace lineservo::support
