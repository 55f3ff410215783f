#include "vehicle/floor/bitmap_view.h"

#include <algorithm>
#include <cmath>

#include "vehicle/floor/clones.h"

namespace lineservo::vehicle {
namespace {

constexpr double kLowest_m = 1e-3;
constexpr float kSmallestFall = 0.01F;  // of a ray; further off is sky

LinearForm linear_form(const Eigen::RowVector3d& row) {
  return {static_cast<float>(row.x()), static_cast<float>(row.y()), static_cast<float>(row.z())};
}

LINESERVO_CLONES void positions(const TileRays& rays, const LinearForm& over, const LinearForm& under,
                                float* position) {
  const LinearForm n = over, d = under;
  for (int i = 0; i < kTilePixels; ++i) {
    const float fall = d.at(rays.x[i], rays.y[i]);
    position[i] = fall > kSmallestFall ? n.at(rays.x[i], rays.y[i]) / fall : -1e6F;
  }
}

}  // namespace

BitmapView::BitmapView(std::shared_ptr<const FloorBitmap> bitmap, const Bgr& around)
    : bitmap_(std::move(bitmap)),
      around_{static_cast<float>(around[0]), static_cast<float>(around[1]), static_cast<float>(around[2])} {}

// p = foot + h r_xy / fall, fall = −r_z, r = R_WC (x, y, 1). In pixels of the bitmap, each s of the level's:
//   u = s ((p_x − o_x) / m + ½) − ½,   v = s (rows − ½ − (p_y − o_y) / m) − ½.
void BitmapView::look_from(const Eigen::Isometry3d& X_WC, double ray_per_pixel) {
  const double height_m = std::max(X_WC.translation().z(), kLowest_m);
  const int level = bitmap_->level_for(height_m * ray_per_pixel);
  const double s = std::ldexp(1.0, -level), per_m = s / bitmap_->metres_per_pixel();
  const Eigen::Vector2d foot_px = per_m * (X_WC.translation().head<2>() - bitmap_->origin_W());
  const Eigen::Matrix3d R_WC = X_WC.linear();
  const Eigen::RowVector3d fall = -R_WC.row(2);
  const double rows = bitmap_->image().rows;
  column_ = linear_form((foot_px.x() + 0.5 * s - 0.5) * fall + per_m * height_m * R_WC.row(0));
  row_ = linear_form((s * (rows - 0.5) - foot_px.y() - 0.5) * fall - per_m * height_m * R_WC.row(1));
  fall_ = linear_form(fall);
  image_ = bitmap_->level(level);
  columns_ = static_cast<float>(s * bitmap_->image().cols);
  rows_ = static_cast<float>(s * rows);
}

// Bilinear; half a pixel beyond the middles of the outermost ones the bitmap ends.
BitmapView::Colour BitmapView::pixel(float column, float row) const {
  const bool is_on_it = column >= -0.5F && row >= -0.5F && column < columns_ - 0.5F && row < rows_ - 0.5F;
  if (!is_on_it) return around_;
  const float c = std::max(column, 0.0F), r = std::max(row, 0.0F);
  const int left = static_cast<int>(c), above = static_cast<int>(r);
  const float f = c - static_cast<float>(left), g = r - static_cast<float>(above);
  const int right = std::min(left + 1, image_.cols - 1), below = std::min(above + 1, image_.rows - 1);
  const std::uint8_t* upper = image_.ptr(above);
  const std::uint8_t* lower = image_.ptr(below);
  Colour colour;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto level = [k](const std::uint8_t* line, int x) {
      return static_cast<float>(line[3 * static_cast<std::size_t>(x) + k]);
    };
    const float up = level(upper, left) + f * (level(upper, right) - level(upper, left));
    const float low = level(lower, left) + f * (level(lower, right) - level(lower, left));
    colour[k] = up + g * (low - up);
  }
  return colour;
}

BitmapView::Colour BitmapView::at(float ray_x, float ray_y) const {
  const float fall = fall_.at(ray_x, ray_y);
  if (!(fall > kSmallestFall)) return around_;
  return pixel(column_.at(ray_x, ray_y) / fall, row_.at(ray_x, ray_y) / fall);
}

void BitmapView::colours(const TileRays& rays, float* blue, float* green, float* red) const {
  std::array<float, kTilePixels> columns, rows;
  positions(rays, column_, fall_, columns.data());
  positions(rays, row_, fall_, rows.data());
  for (std::size_t i = 0; i < kTilePixels; ++i) {
    const Colour colour = pixel(columns[i], rows[i]);
    blue[i] = colour[0];
    green[i] = colour[1];
    red[i] = colour[2];
  }
}

}  // namespace lineservo::vehicle
