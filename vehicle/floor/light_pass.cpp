#include "vehicle/floor/light_pass.h"

#include <algorithm>
#include <cmath>

#include "vehicle/floor/clones.h"

namespace lineservo::vehicle {
namespace {

// Factors in 2⁻¹⁴, glare in 2⁻⁶ of a level: (2⁸ c · factor) / 2¹⁶ is the colour in 2⁻⁶ levels.
constexpr int kFactorOne = 1 << 14;
constexpr int kLevel = 1 << 6;
constexpr int kLargestFactor = 2 * kFactorOne;
constexpr int kLargestGlare = 255 * kLevel;

constexpr int kCellBytes = 3 * 32;

// How far along its cell each byte's pixel is, in 2⁻¹⁵.
struct Shares {
  std::array<std::int16_t, kCellBytes> of_byte = {};
};
constexpr Shares pixel_shares() {
  Shares shares;
  for (int i = 0; i < kCellBytes; ++i)
    shares.of_byte[static_cast<std::size_t>(i)] = static_cast<std::int16_t>((2 * (i / 3) + 1) << 9);
  return shares;
}
constexpr Shares kShares = pixel_shares();

inline std::int16_t part(std::int16_t difference, std::int16_t share) {
  return static_cast<std::int16_t>((difference * share) >> 16);
}

// The differences come doubled, to make up for the shares' 2⁻¹⁵.
LINESERVO_CLONES void light_cell(int factor, int twice_factor_change, int glare, int twice_glare_change,
                                 std::size_t count, std::uint8_t* bytes) {
  const auto f = static_cast<std::uint16_t>(factor), g = static_cast<std::uint16_t>(glare + kLevel / 2);
  const auto df = static_cast<std::int16_t>(twice_factor_change);
  const auto dg = static_cast<std::int16_t>(twice_glare_change);
  for (std::size_t i = 0; i < count; ++i) {
    const auto here = static_cast<std::uint16_t>(f + part(df, kShares.of_byte[i]));
    const auto added = static_cast<std::uint16_t>(g + part(dg, kShares.of_byte[i]));
    const auto colour = static_cast<std::uint16_t>(bytes[i] << 8);
    const auto lit = static_cast<std::uint16_t>((static_cast<std::uint32_t>(colour) * here) >> 16);
    const auto level = static_cast<std::uint16_t>(static_cast<std::uint16_t>(lit + added) >> 6);
    bytes[i] = static_cast<std::uint8_t>(level > 255 ? std::uint16_t{255} : level);
  }
}

// Past the image a lens need not be invertible; a pinhole is.
features::PixelPoint corner_pixel(const features::CameraModel& camera, int x, int y) {
  if (!camera.has_distortion()) return {x - 0.5, y - 0.5};
  return {std::min(x, camera.width_px()) - 0.5, std::min(y, camera.height_px()) - 0.5};
}

int doubled(int difference) {
  return std::clamp(2 * difference, -32767, 32767);
}

}  // namespace

LightPass::LightPass(const features::CameraModel& camera, const LightOptions& options, std::uint64_t seed)
    : columns_((camera.width_px() + kCellWidth_px - 1) / kCellWidth_px),
      rows_((camera.height_px() + kCellHeight_px - 1) / kCellHeight_px),
      light_(options, seed),
      corners_(static_cast<std::size_t>((columns_ + 1) * (rows_ + 1))) {
  for (int row = 0; row <= rows_; ++row)
    for (int column = 0; column <= columns_; ++column) {
      const features::NormalizedPoint ray =
          camera.normalize(corner_pixel(camera, column * kCellWidth_px, row * kCellHeight_px));
      rays_C_.emplace_back(ray.x, ray.y, 1.0);
    }
}

LightPass::Corner LightPass::corner_of(const Lighting& light) {
  return {std::min(static_cast<int>(std::lround(light.factor * kFactorOne)), kLargestFactor),
          std::min(static_cast<int>(std::lround(light.glare * kLargestGlare)), kLargestGlare)};
}

// Where a ray does not meet the floor within reach the light is what it is at that reach, in its direction.
void LightPass::look_from(const Eigen::Isometry3d& X_WC, double reach_m) {
  light_.look_near(X_WC.translation(), reach_m);
  const Eigen::Vector2d foot_W = X_WC.translation().head<2>();
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const Eigen::Vector3d ray_W = X_WC.linear() * rays_C_[i];
    const double across = ray_W.head<2>().norm();
    const double fall = std::max({-ray_W.z(), 1e-9, X_WC.translation().z() * across / reach_m});
    corners_[i] = corner_of(light_.at(foot_W + X_WC.translation().z() / fall * ray_W.head<2>()));
  }
}

LightPass::Corner LightPass::between(int row_px, int column) const {
  const int row = row_px / kCellHeight_px, share = 2 * (row_px % kCellHeight_px) + 1;
  const Corner& upper = corners_[static_cast<std::size_t>(row * (columns_ + 1) + column)];
  const Corner& lower = corners_[static_cast<std::size_t>((row + 1) * (columns_ + 1) + column)];
  constexpr int kWhole = 2 * kCellHeight_px;
  return {upper.factor + (lower.factor - upper.factor) * share / kWhole,
          upper.glare + (lower.glare - upper.glare) * share / kWhole};
}

void LightPass::shade(int first_row, int last_row, cv::Mat& bgr) const {
  for (int row = first_row; row < last_row; ++row) {
    Corner left = between(row, 0);
    for (int column = 0; column < columns_; ++column) {
      const Corner right = between(row, column + 1);
      const int x = column * kCellWidth_px, width = std::min(kCellWidth_px, bgr.cols - x);
      light_cell(left.factor, doubled(right.factor - left.factor), left.glare,
                 doubled(right.glare - left.glare), static_cast<std::size_t>(3 * width),
                 bgr.ptr(row) + 3 * x);
      left = right;
    }
  }
}

}  // namespace lineservo::vehicle
