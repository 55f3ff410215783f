#include "vehicle/floor/floor_renderer.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <opencv2/core.hpp>
#include <stdexcept>

namespace lineservo::vehicle {
namespace {

constexpr Bgr kSky = {180, 175, 170};
constexpr double kFarthestLook_heights = 10.0;
// Ids of paint count from 0; decals share none with it.
constexpr int kFirstDecalId = 1 << 24;

const Layout& sound(const Layout& layout) {
  std::string list;
  for (const std::string& fault : faults(layout)) list += (list.empty() ? "" : "; ") + fault;
  if (!list.empty()) throw std::invalid_argument("layout " + layout.name + ": " + list);
  return layout;
}

/// The markers lie on top.
std::vector<PaintShape> visible_paint(const Layout& layout) {
  std::vector<PaintShape> paint = paint_of(layout);
  const std::size_t markers = layout.start_markers.size() + layout.end_markers.size();
  if (layout.bitmap) paint.erase(paint.begin(), paint.end() - static_cast<std::ptrdiff_t>(markers));
  return paint;
}

// The part of the image under some tiles of one row.
struct Block {
  int x, y, width, height;
};

Block block_of(const cv::Mat& bgr, int row, int first_column, int last_column) {
  const int x = first_column * kTileWidth_px, y = row * kTileHeight_px;
  return {x, y, std::min(last_column * kTileWidth_px, bgr.cols) - x, std::min(kTileHeight_px, bgr.rows - y)};
}

void fill(const Block& block, const Bgr& colour, cv::Mat& bgr) {
  if (block.width <= 0) return;
  std::uint8_t* first = bgr.ptr(block.y) + 3 * block.x;
  for (int i = 0; i < block.width; ++i) std::memcpy(first + 3 * i, colour.data(), 3);
  for (int y = 1; y < block.height; ++y)
    std::memcpy(bgr.ptr(block.y + y) + 3 * block.x, first, static_cast<std::size_t>(3 * block.width));
}

void copy(const TilePixels& pixels, const Block& block, cv::Mat& bgr) {
  for (int y = 0; y < block.height; ++y)
    std::memcpy(bgr.ptr(block.y + y) + 3 * block.x, pixels.data() + 3 * kTileWidth_px * y,
                static_cast<std::size_t>(3 * block.width));
}

}  // namespace

// The flat colour of the tiles from `begin` on, not yet filled in.
struct FloorRenderer::FlatRun {
  int begin;
  Bgr colour;

  void go_on(int row, int column, const Bgr& next, cv::Mat& bgr) {
    if (next == colour) return;
    fill_up_to(row, column, bgr);
    begin = column;
    colour = next;
  }
  void fill_up_to(int row, int column, cv::Mat& bgr) const {
    fill(block_of(bgr, row, begin, column), colour, bgr);
  }
};

FloorRenderer::FloorRenderer(const Layout& layout, const features::CameraModel& camera, const FloorLook& look,
                             std::uint64_t seed)
    : grid_(camera),
      paint_(visible_paint(sound(layout))),
      markers_(layout.start_markers.size() + layout.end_markers.size()),
      floor_colour_(layout.floor_colour),
      ray_per_pixel_(1.0 / camera.parameters().fx_px),
      decals_(layout, look.wear, seed, look.repaint),
      light_(camera, look.light, seed) {
  if (layout.bitmap) bitmap_.emplace(layout.bitmap, layout.floor_colour);
}

void FloorRenderer::render(const Eigen::Isometry3d& X_WC, cv::Mat& bgr) {
  shutter_ = nullptr;
  draw(X_WC, bgr);
}

void FloorRenderer::render(const ShutterWarp::Motion& X_WC, ShutterWarp& shutter, cv::Mat& bgr) {
  shutter.follow(X_WC);
  shutter_ = &shutter;
  draw(X_WC(0.0), bgr);
}

void FloorRenderer::draw(const Eigen::Isometry3d& X_WC, cv::Mat& bgr) {
  bgr.create(grid_.height_px(), grid_.width_px(), CV_8UC3);
  look_from(X_WC);
  narrow(scene_, rects().frame(), frame_);
  for (int row = 0; row < grid_.rows(); ++row) {
    render_row(row, bgr);
    if (light_.is_needed())
      light_.shade(row * kTileHeight_px, std::min((row + 1) * kTileHeight_px, bgr.rows), bgr);
  }
}

// From below: the lines, the holes in them, the markers, what lies on the floor, the sky.
void FloorRenderer::look_from(const Eigen::Isometry3d& X_WC) {
  const FloorView view(X_WC);
  const double reach = reach_m(X_WC);
  if (!decals_.is_none()) decals_.look_near(X_WC.translation().head<2>(), reach);
  if (light_.is_needed()) light_.look_from(X_WC, reach);
  borders_.resize(border_count());
  next_border_ = borders_.data();
  scene_.base = floor_colour_;
  scene_.shapes.clear();
  if (bitmap_) bitmap_->look_from(X_WC, ray_per_pixel_);
  scene_.bitmap = bitmap_ ? &*bitmap_ : nullptr;
  add_paint(view, 0, paint_.size() - markers_);
  add_decals(view, decals_.holes());
  add_paint(view, paint_.size() - markers_, paint_.size());
  add_decals(view, decals_.on_top());
  *next_border_ = view.horizon();
  add(kSky, next_border_, next_border_ + 1);
}

std::size_t FloorRenderer::border_count() const {
  std::size_t count = 1;
  for (const PaintShape& shape : paint_) count += shape.borders.size();
  for (const auto* decals : {&decals_.holes(), &decals_.on_top()})
    for (const PaintShape* shape : *decals) count += shape->borders.size();
  return count;
}

// A little past the farthest of the image's corners: over an exposure it sees more than at its middle.
double FloorRenderer::reach_m(const Eigen::Isometry3d& X_WC) const {
  const RayRect& frame = grid_.rects().frame();
  const double height_m = std::max(X_WC.translation().z(), 0.01);
  double reach = 0.0;
  for (const float x : {frame.x - frame.half_x, frame.x + frame.half_x})
    for (const float y : {frame.y - frame.half_y, frame.y + frame.half_y}) {
      const Eigen::Vector3d ray_W = X_WC.linear() * Eigen::Vector3d(x, y, 1.0);
      const double across = ray_W.head<2>().norm();
      reach = std::max(reach, across / std::max(-ray_W.z(), across / kFarthestLook_heights));
    }
  return 1.1 * reach * height_m;
}

void FloorRenderer::add_paint(const FloorView& view, std::size_t first, std::size_t last) {
  for (std::size_t i = first; i < last; ++i) add_shape(view, paint_[i]);
}

void FloorRenderer::add_decals(const FloorView& view, const std::vector<const PaintShape*>& decals) {
  for (const PaintShape* decal : decals) {
    ImageBorder* first = add_shape(view, *decal);
    for (ImageBorder* border = first; border != next_border_; ++border)
      border->id = kFirstDecalId + static_cast<int>(border - borders_.data());
  }
}

ImageBorder* FloorRenderer::add_shape(const FloorView& view, const PaintShape& shape) {
  ImageBorder* first = next_border_;
  for (const PaintBorder& border : shape.borders) *next_border_++ = view.project(border);
  add(shape.colour, first, next_border_);
  return first;
}

void FloorRenderer::add(const Bgr& colour, const ImageBorder* first, const ImageBorder* last) {
  CrossedShape shape;
  shape.colour = colour;
  for (; first != last; ++first) shape.borders[static_cast<std::size_t>(shape.border_count++)] = first;
  scene_.shapes.push_back(shape);
}

void FloorRenderer::paint(int row, int column, TilePixels& pixels) const {
  if (!shutter_) return paint_tile(grid_.rays(row, column), tile_, pixels);
  std::array<ShutterWarp::Rays, ShutterOptions::kMostSamples> moved;
  std::array<TileRays, ShutterOptions::kMostSamples> instants;
  for (int k = 0; k < shutter_->samples(); ++k) {
    ShutterWarp::Rays& rays = moved[static_cast<std::size_t>(k)];
    shutter_->rays(row, column, k, rays);
    instants[static_cast<std::size_t>(k)] = {rays.x, rays.y, rays.slope};
  }
  paint_tile(instants.data(), shutter_->samples(), tile_, pixels);
}

// Runs of flat tiles of one colour are filled in one go.
void FloorRenderer::render_row(int row, cv::Mat& bgr) {
  narrow(frame_, rects().row(row), row_);
  FlatRun run{0, row_.base};
  for (int span = 0; span < rects().spans(); ++span) {
    narrow(row_, rects().span(row, span), span_);
    const int begin = span * kSpanTiles, end = std::min(begin + kSpanTiles, grid_.columns());
    if (span_.is_flat()) {
      run.go_on(row, begin, span_.base, bgr);
    } else {
      render_span(row, begin, end, run, bgr);
    }
  }
  run.fill_up_to(row, grid_.columns(), bgr);
}

void FloorRenderer::render_span(int row, int begin, int end, FlatRun& run, cv::Mat& bgr) {
  TilePixels pixels;
  for (int column = begin; column < end; ++column) {
    narrow(span_, rects().tile(row, column), tile_);
    run.go_on(row, column, tile_.base, bgr);
    if (tile_.is_flat()) continue;
    run.fill_up_to(row, column, bgr);
    paint(row, column, pixels);
    copy(pixels, block_of(bgr, row, column, column + 1), bgr);
    run.begin = column + 1;
  }
}

}  // namespace lineservo::vehicle
