#include "features/mask/color_contrast.h"

#include <algorithm>
#include <array>
#include <opencv2/imgproc.hpp>

namespace lineservo::features {
namespace {

constexpr int kShrink = 4;    // the floor is looked for in an image so much smaller
constexpr int kDarkest = 24;  // below this level a ratio says nothing
constexpr int kPalest = 48;   // below this level a hue says nothing

std::uint8_t yellowness(int b, int g, int r) {
  const int chroma = std::max(0, std::min(r, g) - b);
  return static_cast<std::uint8_t>(255 * chroma / std::max({r, g, b, kPalest}));
}

std::uint8_t redness(int b, int g, int r) {
  const int chroma = std::max(0, r - std::max(g, b));
  return static_cast<std::uint8_t>(255 * chroma / std::max({r, g, b, kPalest}));
}

cv::Mat hue_cue(const cv::Mat& bgr, LineColor color) {
  cv::Mat cue(bgr.size(), CV_8UC1);
  for (int y = 0; y < bgr.rows; ++y) {
    const auto* in = bgr.ptr<cv::Vec3b>(y);
    auto* out = cue.ptr<std::uint8_t>(y);
    for (int x = 0; x < bgr.cols; ++x) {
      const auto& p = in[x];
      out[x] = color == LineColor::yellow ? yellowness(p[0], p[1], p[2]) : redness(p[0], p[1], p[2]);
    }
  }
  return cue;
}

cv::Mat lightness(const cv::Mat& bgr) {
  cv::Mat light;
  cv::cvtColor(bgr, light, cv::COLOR_BGR2GRAY);
  return light;
}

int quantile(const cv::Mat& image, double share) {
  std::array<int, 256> histogram{};
  for (int y = 0; y < image.rows; ++y)
    for (int x = 0; x < image.cols; ++x) ++histogram[image.at<std::uint8_t>(y, x)];
  const double wanted = share * static_cast<double>(image.total());
  int level = 0;
  for (double seen = histogram[0]; seen < wanted && level < 255;) {
    ++level;
    seen += histogram[static_cast<std::size_t>(level)];
  }
  return level;
}

cv::Mat floor_of_image(const cv::Mat& cue, bool paint_is_darker, double share) {
  const int level = quantile(cue, paint_is_darker ? 1.0 - share : share);
  return {cue.size(), CV_8UC1, cv::Scalar(level)};
}

cv::Mat floor_around(const cv::Mat& cue, bool paint_is_darker, double share) {
  const auto shrunk = [](int side) { return std::max(side / kShrink, 4); };
  cv::Mat small, floor;
  cv::resize(cue, small, {shrunk(cue.cols), shrunk(cue.rows)}, 0.0, 0.0, cv::INTER_AREA);
  const int reach = std::max(3, static_cast<int>(share * std::min(small.cols, small.rows)) | 1);
  const cv::Mat square = cv::getStructuringElement(cv::MORPH_RECT, {reach, reach});
  cv::morphologyEx(small, small, paint_is_darker ? cv::MORPH_CLOSE : cv::MORPH_OPEN, square);
  cv::resize(small, floor, cue.size(), 0.0, 0.0, cv::INTER_LINEAR);
  return floor;
}

std::uint8_t ratio(int darker, int lighter) {
  return static_cast<std::uint8_t>(255 * std::max(0, lighter - darker) / std::max(lighter, kDarkest));
}

cv::Mat compared(const cv::Mat& cue, const cv::Mat& floor, LineColor color) {
  cv::Mat contrast(cue.size(), CV_8UC1);
  for (int y = 0; y < cue.rows; ++y) {
    const auto* here = cue.ptr<std::uint8_t>(y);
    const auto* around = floor.ptr<std::uint8_t>(y);
    auto* out = contrast.ptr<std::uint8_t>(y);
    for (int x = 0; x < cue.cols; ++x)
      out[x] = color == LineColor::black ? ratio(here[x], around[x]) : ratio(around[x], here[x]);
  }
  return contrast;
}

}  // namespace

cv::Mat color_cue(const cv::Mat& bgr, LineColor color) {
  cv::Mat cue = has_hue(color) ? hue_cue(bgr, color) : lightness(bgr);
  cv::blur(cue, cue, {3, 3});
  return cue;
}

cv::Mat color_contrast(const cv::Mat& bgr, LineColor color, ContrastReach reach) {
  const bool paint_is_darker = color == LineColor::black;
  const cv::Mat cue = color_cue(bgr, color);
  const cv::Mat floor = reach.share < 1.0 ? floor_around(cue, paint_is_darker, reach.share)
                                          : floor_of_image(cue, paint_is_darker, reach.floor_share);
  if (!has_hue(color)) return compared(cue, floor, color);
  cv::Mat contrast;
  cv::subtract(cue, floor, contrast);  // stops at zero
  return contrast;
}

}  // namespace lineservo::features
