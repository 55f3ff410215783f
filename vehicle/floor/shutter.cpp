#include "vehicle/floor/shutter.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "vehicle/floor/clones.h"

namespace lineservo::vehicle {
namespace {

bool within(double value, double low, double high) {
  return value >= low && value <= high;
}

struct Homography {
  float xx, xy, x1, yx, yy, y1, wx, wy, w1;
};

Homography single(const Eigen::Matrix3d& H) {
  const Eigen::Matrix3f h = H.cast<float>();
  return {h(0, 0), h(0, 1), h(0, 2), h(1, 0), h(1, 1), h(1, 2), h(2, 0), h(2, 1), h(2, 2)};
}

// Away from the horizon w is near 1; what is past it is sky, wherever it moves.
constexpr float kLeastDepth = 0.05F;

LINESERVO_CLONES void displace(const Homography& H, const float* x, const float* y, int count, float* off_x,
                               float* off_y) {
  for (int i = 0; i < count; ++i) {
    const float per_w = 1.0F / std::max(H.wx * x[i] + H.wy * y[i] + H.w1, kLeastDepth);
    off_x[i] = (H.xx * x[i] + H.xy * y[i] + H.x1) * per_w - x[i];
    off_y[i] = (H.yx * x[i] + H.yy * y[i] + H.y1) * per_w - y[i];
  }
}

// How far each pixel of a tile is from the tile's centre.
struct PixelOffsets {
  std::array<float, kTilePixels> u = {}, v = {};
};
constexpr PixelOffsets pixel_offsets() {
  PixelOffsets offsets;
  for (int i = 0; i < kTilePixels; ++i) {
    offsets.u[static_cast<std::size_t>(i)] =
        static_cast<float>(i % kTileWidth_px) - 0.5F * (kTileWidth_px - 1);
    offsets.v[static_cast<std::size_t>(i)] =
        static_cast<float>(i / kTileWidth_px) - 0.5F * (kTileHeight_px - 1);
  }
  return offsets;
}
constexpr PixelOffsets kOffsets = pixel_offsets();

// A displacement over a tile: its middle and its change per pixel.
struct Drift {
  float middle, per_u, per_v;
};

Drift drift_between(float left_top, float right_top, float left_bottom, float right_bottom) {
  return {0.25F * (left_top + right_top + left_bottom + right_bottom),
          0.5F / kTileWidth_px * (right_top + right_bottom - left_top - left_bottom),
          0.5F / kTileHeight_px * (left_bottom + right_bottom - left_top - right_top)};
}

LINESERVO_CLONES void drift_away(const float* rays, const Drift& drift, float* moved) {
  for (std::size_t i = 0; i < kTilePixels; ++i)
    moved[i] = rays[i] + (drift.middle + drift.per_u * kOffsets.u[i] + drift.per_v * kOffsets.v[i]);
}

LINESERVO_CLONES void widen(const float* values, int count, float* low, float* high) {
  for (int i = 0; i < count; ++i) {
    low[i] = std::min(low[i], values[i]);
    high[i] = std::max(high[i], values[i]);
  }
}

// Rounding of the displaced rays.
constexpr float kSlack = 1e-5F;

void stretch(float low, float high, float& centre, float& half) {
  centre += 0.5F * (low + high);
  half += 0.5F * (high - low) + kSlack;
}

}  // namespace

void ShutterOptions::validate() const {
  if (!within(exposure_s, 0.0, 0.1)) throw std::invalid_argument("camera: the exposure must be 0 to 0.1 s");
  if (!within(readout_s, 0.0, 0.1)) throw std::invalid_argument("camera: the readout must be 0 to 0.1 s");
  if (samples < 1 || samples > kMostSamples)
    throw std::invalid_argument("camera: the exposure's samples must be 1 to 32");
}

double row_delay_s(const ShutterOptions& options, double row_px, int height_px) {
  return (row_px / height_px - 0.5) * options.readout_s;
}

double sample_delay_s(const ShutterOptions& options, int k) {
  return ((k + 0.5) / options.samples - 0.5) * options.exposure_s;
}

ShutterWarp::ShutterWarp(const TileGrid& grid, const ShutterOptions& options)
    : grid_(&grid), options_(options), rects_(grid.rows(), grid.columns()) {
  options_.validate();
  if (options_.exposure_s == 0.0) options_.samples = 1;
  const auto corners = static_cast<std::size_t>((grid.rows() + 1) * (grid.columns() + 1));
  off_x_.resize(corners * static_cast<std::size_t>(options_.samples));
  off_y_.resize(off_x_.size());
}

std::size_t ShutterWarp::corner(int k, int row, int column) const {
  return static_cast<std::size_t>((k * (grid_->rows() + 1) + row) * (grid_->columns() + 1) + column);
}

void ShutterWarp::follow(const Motion& X_WC) {
  const Eigen::Isometry3d X_WC0 = X_WC(0.0);
  for (int k = 0; k < options_.samples; ++k)
    for (int row = 0; row <= grid_->rows(); ++row) {
      const double delay_s =
          row_delay_s(options_, row * kTileHeight_px, grid_->height_px()) + sample_delay_s(options_, k);
      const Eigen::Isometry3d X = X_WC(delay_s);
      Eigen::Matrix3d to_floor = X.translation().z() * Eigen::Matrix3d::Identity();
      to_floor.col(2) -= X.translation() - X_WC0.translation();
      displace_corners(k, row, X_WC0.linear().transpose() * to_floor * X.linear() / X_WC0.translation().z());
    }
  bound();
}

void ShutterWarp::displace_corners(int k, int row, const Eigen::Matrix3d& H) {
  const std::size_t first = corner(k, row, 0);
  displace(single(H), grid_->corners_x(row), grid_->corners_y(row), grid_->columns() + 1, &off_x_[first],
           &off_y_[first]);
}

// The corners' displacements over all instants, at the upper or lower edge of a row of tiles, then of each
// tile.
void ShutterWarp::bound() {
  for (int row = 0; row < grid_->rows(); ++row) {
    const Range x = range_of_row(off_x_, row), y = range_of_row(off_y_, row);
    for (int column = 0; column < grid_->columns(); ++column) {
      const auto left = static_cast<std::size_t>(column), right = left + 1;
      RayRect rect = grid_->rects().tile(row, column);
      stretch(std::min(x.low[left], x.low[right]), std::max(x.high[left], x.high[right]), rect.x,
              rect.half_x);
      stretch(std::min(y.low[left], y.low[right]), std::max(y.high[left], y.high[right]), rect.y,
              rect.half_y);
      rects_.set(row, column, rect);
    }
  }
  rects_.close();
}

ShutterWarp::Range ShutterWarp::range_of_row(const std::vector<float>& off, int row) const {
  const int corners = grid_->columns() + 1;
  const float* first = &off[corner(0, row, 0)];
  Range range{{first, first + corners}, {first, first + corners}};
  for (int k = 0; k < options_.samples; ++k)
    for (const int edge : {row, row + 1})
      widen(&off[corner(k, edge, 0)], corners, range.low.data(), range.high.data());
  return range;
}

void ShutterWarp::rays(int row, int column, int k, Rays& moved) const {
  const TileRays still = grid_->rays(row, column);
  const std::size_t top = corner(k, row, column), bottom = corner(k, row + 1, column);
  const Drift x = drift_between(off_x_[top], off_x_[top + 1], off_x_[bottom], off_x_[bottom + 1]);
  const Drift y = drift_between(off_y_[top], off_y_[top + 1], off_y_[bottom], off_y_[bottom + 1]);
  drift_away(still.x, x, moved.x);
  drift_away(still.y, y, moved.y);
  moved.slope = {still.slope.x_u + x.per_u, still.slope.x_v + x.per_v, still.slope.y_u + y.per_u,
                 still.slope.y_v + y.per_v};
}

}  // namespace lineservo::vehicle
