#pragma once

#include <vector>

namespace lineservo::vehicle {

/// An upright rectangle of the normalised image plane.
struct RayRect {
  float x = 0.0F, y = 0.0F;            ///< centre
  float half_x = 0.0F, half_y = 0.0F;  ///< half sides
};

/// So many tiles of a row are looked at together first.
inline constexpr int kSpanTiles = 8;

/// Bounds of rays: of each tile, and from them of each span of a row, each row, and the frame.
class TileRects {
 public:
  TileRects(int rows, int columns);

  /// To be set for all tiles, then close().
  void set(int row, int column, const RayRect& rect) { tiles_[index(row, column)] = rect; }
  void close();

  int spans() const { return spans_; }
  const RayRect& tile(int row, int column) const { return tiles_[index(row, column)]; }
  const RayRect& span(int row, int span) const {
    return of_spans_[static_cast<std::size_t>(row * spans_ + span)];
  }
  const RayRect& row(int row) const { return of_rows_[static_cast<std::size_t>(row)]; }
  const RayRect& frame() const { return frame_; }

 private:
  std::size_t index(int row, int column) const { return static_cast<std::size_t>(row * columns_ + column); }

  int rows_, columns_, spans_;
  std::vector<RayRect> tiles_, of_spans_, of_rows_;
  RayRect frame_;
};

}  // namespace lineservo::vehicle
