#include "vehicle/floor/cell.h"

#include <algorithm>

namespace lineservo::vehicle {
namespace {

// The shape with only the borders that cross the rectangle; false when it lies outside altogether.
bool narrow(const CrossedShape& whole, const RayRect& rect, CrossedShape& part) {
  part.colour = whole.colour;
  part.border_count = 0;
  for (int i = 0; i < whole.border_count; ++i) {
    const ImageBorder* border = whole.borders[static_cast<std::size_t>(i)];
    const Side side = side_of(*border, rect);
    if (side == Side::bare) return false;
    if (side == Side::crossed) part.borders[static_cast<std::size_t>(part.border_count++)] = border;
  }
  return true;
}

// A shape that covers everything hides what is below it.
void cover(const Bgr& colour, Cell& cell) {
  cell.base = colour;
  cell.bitmap = nullptr;
  cell.shapes.clear();
}

}  // namespace

bool Cell::has_single_border() const {
  if (shapes.empty() || bitmap) return false;
  const CrossedShape& first = shapes.front();
  return std::all_of(shapes.begin(), shapes.end(), [&first](const CrossedShape& shape) {
    return shape.border_count == 1 && shape.borders[0]->id == first.borders[0]->id &&
           shape.colour == first.colour;
  });
}

void narrow(const Cell& whole, const RayRect& rect, Cell& part) {
  cover(whole.base, part);
  part.bitmap = whole.bitmap;
  CrossedShape crossed;
  for (const CrossedShape& shape : whole.shapes) {
    if (!narrow(shape, rect, crossed)) continue;
    if (crossed.border_count == 0) {
      cover(crossed.colour, part);
    } else if (!part.is_flat() || crossed.colour != part.base) {
      part.shapes.push_back(crossed);
    }
  }
}

}  // namespace lineservo::vehicle
