#pragma once

#include <array>
#include <cstdint>

#include "vehicle/floor/cell.h"
#include "vehicle/floor/tile_grid.h"

namespace lineservo::vehicle {

/// The pixels of one tile, row by row, interleaved BGR.
using TilePixels = std::array<std::uint8_t, 3 * kTilePixels>;

/// Draws a tile that is not flat. A pixel is the mean colour over its square: in closed form where one border
/// crosses it, from 64 samples where several do.
void paint_tile(const TileRays& rays, const Cell& cell, TilePixels& bgr);

/// The mean over several instants, each with its own rays. Requires count ≥ 1.
void paint_tile(const TileRays* instants, int count, const Cell& cell, TilePixels& bgr);

}  // namespace lineservo::vehicle
