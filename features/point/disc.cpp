#include "features/point/disc.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "features/mask/mask_profile.h"

namespace lineservo::features {
namespace {

// vtp's camera and flight: 11 px in a frame 160 px wide, f = 145 px, from 1.1 m.
constexpr int kWidth_px = 160;
constexpr double kRadius_m = 11.0 * 1.1 / 145.0;

}  // namespace

std::optional<PixelPoint> start_disc(const PackedMask& marker, int limit_px) {
  const MaskProfile profile = profile_of(marker);
  return profile.foreground > limit_px ? centroid(profile) : std::nullopt;
}

// A pixel survives the erosion when no background lies within the radius of it.
std::optional<PixelPoint> end_disc(const PackedMask& path, double radius_px) {
  if (!(radius_px >= 1.0 && radius_px <= 500.0))
    throw std::invalid_argument("end disc: the radius must be 1 to 500 px");
  cv::Mat background_px;
  cv::distanceTransform(path.to_mat(), background_px, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  return centroid(profile_of(PackedMask::from_mat(background_px > radius_px)));
}

std::optional<PixelPoint> end_disc_as_published(const PackedMask& path, const CameraModel& camera,
                                                double height_m) {
  const int height_px = std::max(1, kWidth_px * camera.height_px() / camera.width_px());
  const double radius_px = kRadius_m / height_m * camera.parameters().fx_px * kWidth_px / camera.width_px();
  cv::Mat small;
  cv::resize(path.to_mat(), small, {kWidth_px, height_px}, 0.0, 0.0, cv::INTER_NEAREST);
  const std::optional<PixelPoint> centre =
      end_disc(PackedMask::from_mat(small), std::clamp(radius_px, 1.0, 500.0));
  if (!centre) return std::nullopt;
  const double scale_x = static_cast<double>(path.width()) / kWidth_px;
  const double scale_y = static_cast<double>(path.height()) / height_px;
  return PixelPoint{(centre->x + 0.5) * scale_x - 0.5, (centre->y + 0.5) * scale_y - 0.5};
}

}  // namespace lineservo::features
