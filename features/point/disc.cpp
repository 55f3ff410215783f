#include "features/point/disc.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "features/mask/mask_profile.h"

namespace lineservo::features {
namespace {

/// All pixels whose centres lie within the radius.
cv::Mat disc(int radius_px) {
  cv::Mat kernel(2 * radius_px + 1, 2 * radius_px + 1, CV_8UC1);
  for (int dy = -radius_px; dy <= radius_px; ++dy)
    for (int dx = -radius_px; dx <= radius_px; ++dx)
      kernel.at<std::uint8_t>(dy + radius_px, dx + radius_px) =
          dx * dx + dy * dy <= radius_px * radius_px ? 1 : 0;
  return kernel;
}

}  // namespace

std::optional<PixelPoint> start_disc(const PackedMask& marker, int limit_px) {
  const MaskProfile profile = profile_of(marker);
  return profile.foreground > limit_px ? centroid(profile) : std::nullopt;
}

std::optional<PixelPoint> end_disc(const PackedMask& path, int radius_px) {
  if (radius_px < 1 || radius_px > 500)
    throw std::invalid_argument("end disc: the radius must be 1 to 500 px");
  cv::Mat eroded;
  cv::erode(path.to_mat(), eroded, disc(radius_px));
  return centroid(profile_of(PackedMask::from_mat(eroded)));
}

std::optional<PixelPoint> end_disc_as_published(const PackedMask& path, cv::Size camera_size) {
  constexpr int kWidth_px = 160;
  const int height_px = std::max(1, kWidth_px * camera_size.height / camera_size.width);
  cv::Mat small;
  cv::resize(path.to_mat(), small, {kWidth_px, height_px}, 0.0, 0.0, cv::INTER_NEAREST);
  const std::optional<PixelPoint> centre = end_disc(PackedMask::from_mat(small));
  if (!centre) return std::nullopt;
  const double scale_x = static_cast<double>(path.width()) / kWidth_px;
  const double scale_y = static_cast<double>(path.height()) / height_px;
  return PixelPoint{(centre->x + 0.5) * scale_x - 0.5, (centre->y + 0.5) * scale_y - 0.5};
}

}  // namespace lineservo::features
