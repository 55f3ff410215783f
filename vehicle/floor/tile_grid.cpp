#include "vehicle/floor/tile_grid.h"

#include <algorithm>
#include <cmath>

namespace lineservo::vehicle {
namespace {

using features::CameraModel;
using features::NormalizedPoint;
using features::PixelPoint;

// Rounding, and the bend of distorted pixels: 5 % of half a pixel.
constexpr float kHalfPixel = 0.525F;

std::size_t block(int i) {
  return static_cast<std::size_t>(i) * kTilePixels;
}

// What of a tile lies past the image stands for the image's last pixel: out there a lens need not be
// invertible.
PixelPoint within(const CameraModel& camera, PixelPoint p) {
  return {std::min(p.x, camera.width_px() - 1.0), std::min(p.y, camera.height_px() - 1.0)};
}

PixelPoint pixel_of(const CameraModel& camera, int row, int column, int i) {
  const int x = column * kTileWidth_px + i % kTileWidth_px;
  const int y = row * kTileHeight_px + i / kTileWidth_px;
  return within(camera, {static_cast<double>(x), static_cast<double>(y)});
}

RayRect rect_between(float x_min, float x_max, float y_min, float y_max) {
  return {0.5F * (x_min + x_max), 0.5F * (y_min + y_max), 0.5F * (x_max - x_min), 0.5F * (y_max - y_min)};
}

RayRect rect_of(const TileRays& rays) {
  const auto [x_min, x_max] = std::minmax_element(rays.x, rays.x + kTilePixels);
  const auto [y_min, y_max] = std::minmax_element(rays.y, rays.y + kTilePixels);
  RayRect rect = rect_between(*x_min, *x_max, *y_min, *y_max);
  rect.half_x += kHalfPixel * (std::abs(rays.slope.x_u) + std::abs(rays.slope.x_v));
  rect.half_y += kHalfPixel * (std::abs(rays.slope.y_u) + std::abs(rays.slope.y_v));
  return rect;
}

// Central differences over one pixel; exact without distortion.
RayJacobian slope_at(const CameraModel& camera, PixelPoint p) {
  const NormalizedPoint left = camera.normalize({p.x - 0.5, p.y}), right = camera.normalize({p.x + 0.5, p.y});
  const NormalizedPoint up = camera.normalize({p.x, p.y - 0.5}), down = camera.normalize({p.x, p.y + 0.5});
  return {static_cast<float>(right.x - left.x), static_cast<float>(down.x - up.x),
          static_cast<float>(right.y - left.y), static_cast<float>(down.y - up.y)};
}

}  // namespace

TileGrid::TileGrid(const CameraModel& camera)
    : width_px_(camera.width_px()),
      height_px_(camera.height_px()),
      columns_((camera.width_px() + kTileWidth_px - 1) / kTileWidth_px),
      rows_((camera.height_px() + kTileHeight_px - 1) / kTileHeight_px),
      is_separable_(!camera.has_distortion()),
      rects_(rows_, columns_) {
  if (is_separable_) {
    store_separable_rays(camera);
  } else {
    store_distorted_rays(camera);
  }
  store_corners(camera);
  store_slopes(camera);
  store_rects();
}

TileRays TileGrid::rays(int row, int column) const {
  const int tile = row * columns_ + column;
  return {x_.data() + block(is_separable_ ? column : tile), y_.data() + block(is_separable_ ? row : tile),
          slopes_[index(row, column)]};
}

void TileGrid::store_separable_rays(const CameraModel& camera) {
  for (int column = 0; column < columns_; ++column)
    for (int i = 0; i < kTilePixels; ++i)
      x_.push_back(static_cast<float>(camera.normalize(pixel_of(camera, 0, column, i)).x));
  for (int row = 0; row < rows_; ++row)
    for (int i = 0; i < kTilePixels; ++i)
      y_.push_back(static_cast<float>(camera.normalize(pixel_of(camera, row, 0, i)).y));
}

void TileGrid::store_distorted_rays(const CameraModel& camera) {
  for (int tile = 0; tile < rows_ * columns_; ++tile)
    for (int i = 0; i < kTilePixels; ++i) {
      const NormalizedPoint ray = camera.normalize(pixel_of(camera, tile / columns_, tile % columns_, i));
      x_.push_back(static_cast<float>(ray.x));
      y_.push_back(static_cast<float>(ray.y));
    }
}

void TileGrid::store_corners(const CameraModel& camera) {
  for (int row = 0; row <= rows_; ++row)
    for (int column = 0; column <= columns_; ++column) {
      const PixelPoint corner{column * kTileWidth_px - 0.5, row * kTileHeight_px - 0.5};
      const NormalizedPoint ray = camera.normalize(is_separable_ ? corner : within(camera, corner));
      corners_x_.push_back(static_cast<float>(ray.x));
      corners_y_.push_back(static_cast<float>(ray.y));
    }
}

void TileGrid::store_slopes(const CameraModel& camera) {
  const auto& p = camera.parameters();
  const RayJacobian pinhole{static_cast<float>(1.0 / p.fx_px), 0.0F, 0.0F, static_cast<float>(1.0 / p.fy_px)};
  for (int tile = 0; tile < rows_ * columns_; ++tile) {
    const PixelPoint first = pixel_of(camera, tile / columns_, tile % columns_, 0);
    const PixelPoint centre =
        within(camera, {first.x + 0.5 * (kTileWidth_px - 1), first.y + 0.5 * (kTileHeight_px - 1)});
    slopes_.push_back(is_separable_ ? pinhole : slope_at(camera, centre));
  }
}

void TileGrid::store_rects() {
  for (int row = 0; row < rows_; ++row)
    for (int column = 0; column < columns_; ++column) rects_.set(row, column, rect_of(rays(row, column)));
  rects_.close();
}

}  // namespace lineservo::vehicle
