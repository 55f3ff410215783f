#include "vehicle/floor/floor_renderer.h"

#include <algorithm>
#include <cstring>
#include <opencv2/core.hpp>
#include <stdexcept>

#include "vehicle/floor/tile_painter.h"

namespace lineservo::vehicle {
namespace {

constexpr Bgr kSky = {180, 175, 170};

const Layout& sound(const Layout& layout) {
  std::string list;
  for (const std::string& fault : faults(layout)) list += (list.empty() ? "" : "; ") + fault;
  if (!list.empty()) throw std::invalid_argument("layout " + layout.name + ": " + list);
  return layout;
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

FloorRenderer::FloorRenderer(const Layout& layout, const features::CameraModel& camera)
    : grid_(camera), paint_(paint_of(sound(layout))), floor_colour_(layout.floor_colour) {
  std::size_t borders = 1;
  for (const PaintShape& shape : paint_) borders += shape.borders.size();
  borders_.resize(borders);
}

void FloorRenderer::render(const Eigen::Isometry3d& X_WC, cv::Mat& bgr) {
  bgr.create(grid_.height_px(), grid_.width_px(), CV_8UC3);
  look_from(X_WC);
  narrow(scene_, grid_.frame_rect(), frame_);
  for (int row = 0; row < grid_.rows(); ++row) render_row(row, bgr);
}

void FloorRenderer::look_from(const Eigen::Isometry3d& X_WC) {
  const FloorView view(X_WC);
  scene_.base = floor_colour_;
  scene_.shapes.clear();
  ImageBorder* next = borders_.data();
  for (const PaintShape& shape : paint_) {
    ImageBorder* first = next;
    for (const PaintBorder& border : shape.borders) *next++ = view.project(border);
    add(shape.colour, first, next);
  }
  *next = view.horizon();
  add(kSky, next, next + 1);
}

void FloorRenderer::add(const Bgr& colour, const ImageBorder* first, const ImageBorder* last) {
  CrossedShape shape;
  shape.colour = colour;
  for (; first != last; ++first) shape.borders[static_cast<std::size_t>(shape.border_count++)] = first;
  scene_.shapes.push_back(shape);
}

// Runs of flat tiles of one colour are filled in one go.
void FloorRenderer::render_row(int row, cv::Mat& bgr) {
  narrow(frame_, grid_.row_rect(row), row_);
  TilePixels pixels;
  int run_begin = 0;
  Bgr run_colour = row_.base;
  const auto end_run = [&](int column) { fill(block_of(bgr, row, run_begin, column), run_colour, bgr); };
  for (int column = 0; column < grid_.columns(); ++column) {
    narrow(row_, grid_.tile_rect(row, column), tile_);
    if (tile_.is_flat() && tile_.base == run_colour) continue;
    end_run(column);
    run_begin = column;
    run_colour = tile_.base;
    if (tile_.is_flat()) continue;
    paint_tile(grid_.rays(row, column), tile_, pixels);
    copy(pixels, block_of(bgr, row, column, column + 1), bgr);
    run_begin = column + 1;
  }
  end_run(grid_.columns());
}

}  // namespace lineservo::vehicle
