#pragma once

#include <array>
#include <vector>

#include "vehicle/floor/image_border.h"

namespace lineservo::vehicle {

class BitmapView;

/// A painted shape with those of its borders that matter in some part of the image.
struct CrossedShape {
  Bgr colour = {};
  int border_count = 0;
  std::array<const ImageBorder*, kMaxBorders> borders = {};
};

/// What is to be seen in a part of the image: a base colour, or a bitmap in its place, and, in paint order,
/// the shapes whose borders cross it. Neither bitmap nor shapes: it is flat.
struct Cell {
  Bgr base = {};
  const BitmapView* bitmap = nullptr;
  std::vector<CrossedShape> shapes;

  bool is_flat() const { return shapes.empty() && !bitmap; }
  /// All shapes are one colour, over another, and bounded by one and the same border.
  bool has_single_border() const;
};

/// What of `whole` is to be seen in a rectangle within it. `part` is written over; its memory is reused.
void narrow(const Cell& whole, const RayRect& rect, Cell& part);

}  // namespace lineservo::vehicle
