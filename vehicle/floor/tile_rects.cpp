#include "vehicle/floor/tile_rects.h"

#include <algorithm>

namespace lineservo::vehicle {
namespace {

RayRect around(const RayRect* first, const RayRect* last) {
  float x_min = first->x, x_max = first->x, y_min = first->y, y_max = first->y;
  for (const RayRect* r = first; r != last; ++r) {
    x_min = std::min(x_min, r->x - r->half_x);
    x_max = std::max(x_max, r->x + r->half_x);
    y_min = std::min(y_min, r->y - r->half_y);
    y_max = std::max(y_max, r->y + r->half_y);
  }
  return {0.5F * (x_min + x_max), 0.5F * (y_min + y_max), 0.5F * (x_max - x_min), 0.5F * (y_max - y_min)};
}

}  // namespace

TileRects::TileRects(int rows, int columns)
    : rows_(rows),
      columns_(columns),
      spans_((columns + kSpanTiles - 1) / kSpanTiles),
      tiles_(static_cast<std::size_t>(rows * columns)),
      of_spans_(static_cast<std::size_t>(rows * spans_)),
      of_rows_(static_cast<std::size_t>(rows)) {}

void TileRects::close() {
  for (int row = 0; row < rows_; ++row) {
    RayRect* spans = &of_spans_[static_cast<std::size_t>(row * spans_)];
    const RayRect* tiles = &tiles_[index(row, 0)];
    for (int span = 0; span < spans_; ++span)
      spans[span] = around(tiles + span * kSpanTiles, tiles + std::min((span + 1) * kSpanTiles, columns_));
    of_rows_[static_cast<std::size_t>(row)] = around(spans, spans + spans_);
  }
  frame_ = around(of_rows_.data(), of_rows_.data() + of_rows_.size());
}

}  // namespace lineservo::vehicle
