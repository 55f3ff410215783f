#include "features/line/stripe_search.h"

#include <algorithm>
#include <cmath>

namespace lineservo::features {
namespace {

constexpr int kMaskSide_px = 640;   // the finder's tolerances are about a pixel of such a mask
constexpr int kLeastSide_px = 16;   // of a camera image and of a mask
constexpr int kMostSide_px = 4096;  // of a mask
constexpr int kFineSide_px = 800;   // a mask wider than this is scanned at every eighth row and column

bool same(const CameraParameters& a, const CameraParameters& b) {
  return a.width_px == b.width_px && a.height_px == b.height_px && a.fx_px == b.fx_px && a.fy_px == b.fy_px &&
         a.cx_px == b.cx_px && a.cy_px == b.cy_px && a.distortion == b.distortion;
}

bool usable(const PackedMask& mask) {
  return std::min(mask.width(), mask.height()) >= kLeastSide_px &&
         std::max(mask.width(), mask.height()) <= kMostSide_px;
}

}  // namespace

StripeSearch::StripeSearch(const StripeOptions& options) : finder_(options) {}

CameraPose StripeSearch::assumed_camera(cv::Size image) {
  const double focal_px = 0.5 * image.width;
  return {CameraModel({.width_px = image.width,
                       .height_px = image.height,
                       .fx_px = focal_px,
                       .fy_px = focal_px,
                       .cx_px = 0.5 * (image.width - 1),
                       .cy_px = 0.5 * (image.height - 1)}),
          LevelView()};
}

cv::Size StripeSearch::mask_size(cv::Size image) {
  const double scale = std::min(1.0, static_cast<double>(kMaskSide_px) / std::max(image.width, image.height));
  const auto side = [scale](int px) {
    return std::max(kLeastSide_px, static_cast<int>(std::lround(scale * px)));
  };
  return {side(image.width), side(image.height)};
}

const std::vector<Stripe>& StripeSearch::find(const PackedMask& mask, const CameraPose& pose,
                                              const std::optional<StripePrior>& prior) {
  stripes_.clear();
  points_.clear();
  if (!usable(mask)) return stripes_;
  prepare(mask, pose.camera);
  const LevelMask level(mask.view(), *geometry_, pose.view);
  (mask.width() > kFineSide_px ? coarse_ : fine_).extract(level, points_);
  finder_.find(level, points_, prior, stripes_);
  return stripes_;
}

void StripeSearch::prepare(const PackedMask& mask, const CameraModel& camera) {
  if (geometry_ && geometry_->width_px() == mask.width() && geometry_->height_px() == mask.height() &&
      same(camera.parameters(), camera_))
    return;
  geometry_ = std::make_unique<MaskGeometry>(camera, mask.width(), mask.height());
  camera_ = camera.parameters();
}

}  // namespace lineservo::features
