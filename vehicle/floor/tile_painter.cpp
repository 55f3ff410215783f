#include "vehicle/floor/tile_painter.h"

#include <algorithm>
#include <cmath>

#include "vehicle/floor/bitmap_view.h"
#include "vehicle/floor/clones.h"
#include "vehicle/floor/shutter_options.h"

namespace lineservo::vehicle {
namespace {

using Plane = std::array<float, kTilePixels>;

// The pixel's square against a straight border with the unit normal (cos, sin) in the image: the covered area
// as a function of the signed distance e of the pixel's centre. With a = max(|cos|, |sin|), b = min of them,
// it is the convolution of boxes of the widths a and b with a step: 1/2 ± A(|e|),
//   A(t) = min(t, (a + b)/2)/a − m²/(2 a b),   m = clamp(t − (a − b)/2, 0, b).
inline float covered_area(float e, float a, float b) {
  const float t = std::abs(e);
  const float half = 0.5F * (a + b);
  const float m = std::min(std::max(t - 0.5F * (a - b), 0.0F), b);
  const float area = t >= half ? 0.5F : t / a - m * m / (2.0F * a * b);
  return e >= 0.0F ? 0.5F + area : 0.5F - area;
}

// Keeps m²/(2 a b) finite for a border along the pixel grid; it moves no area by more than 1e-4.
constexpr float kLeastSlope = 1e-4F;

// Image gradient of a border function by the chain rule; e = −F/|∇F| is the distance in pixels.
struct PixelSlope {
  float per_F, a, b;
};
inline PixelSlope pixel_slope(float F_x, float F_y, const RayJacobian& j) {
  const float F_u = F_x * j.x_u + F_y * j.y_u, F_v = F_x * j.x_v + F_y * j.y_v;
  const float per_F = 1.0F / std::max(std::sqrt(F_u * F_u + F_v * F_v), 1e-20F);
  const float c = std::abs(F_u) * per_F, s = std::abs(F_v) * per_F;
  return {per_F, std::max(c, s), std::max(std::min(c, s), kLeastSlope)};
}

LINESERVO_CLONES void straight_coverage(const TileRays& rays, const ImageBorder& border, float* coverage) {
  const LinearForm l0 = border.l0;
  const PixelSlope slope = pixel_slope(l0.x, l0.y, rays.slope);
  for (int i = 0; i < kTilePixels; ++i)
    coverage[i] = covered_area(-l0.at(rays.x[i], rays.y[i]) * slope.per_F, slope.a, slope.b);
}

LINESERVO_CLONES void round_coverage(const TileRays& rays, const ImageBorder& border, float* coverage) {
  const LinearForm l0 = border.l0, l1 = border.l1, l2 = border.l2;
  const float sign = border.sign;
  const RayJacobian j = rays.slope;
  for (int i = 0; i < kTilePixels; ++i) {
    const float f1 = l1.at(rays.x[i], rays.y[i]), f2 = l2.at(rays.x[i], rays.y[i]);
    const float r = std::max(std::sqrt(f1 * f1 + f2 * f2), 1e-20F);
    const float F_x = (f1 * l1.x + f2 * l2.x) / r + l0.x, F_y = (f1 * l1.y + f2 * l2.y) / r + l0.y;
    const PixelSlope slope = pixel_slope(F_x, F_y, j);
    coverage[i] = covered_area(-sign * (r + l0.at(rays.x[i], rays.y[i])) * slope.per_F, slope.a, slope.b);
  }
}

void border_coverage(const TileRays& rays, const ImageBorder& border, Plane& coverage) {
  (border.is_round ? round_coverage : straight_coverage)(rays, border, coverage.data());
}

LINESERVO_CLONES void interleave(const Plane& b, const Plane& g, const Plane& r, TilePixels& bgr) {
  for (std::size_t i = 0; i < kTilePixels; ++i) {
    bgr[3 * i] = static_cast<std::uint8_t>(static_cast<int>(b[i] + 0.5F));
    bgr[3 * i + 1] = static_cast<std::uint8_t>(static_cast<int>(g[i] + 0.5F));
    bgr[3 * i + 2] = static_cast<std::uint8_t>(static_cast<int>(r[i] + 0.5F));
  }
}

// A tile as it builds up: three colour planes, and how many borders cross each pixel's visible paint.
struct Layers {
  std::array<Plane, 3> bgr;
  Plane crossings;
};

// One shape: the product of its borders' coverages, and the number of borders that cross the pixel.
struct ShapeCoverage {
  Plane area;
  Plane crossings;
};

LINESERVO_CLONES void restrict_to(const float* border_area, ShapeCoverage& shape) {
  for (std::size_t i = 0; i < kTilePixels; ++i) {
    const float c = border_area[i];
    shape.area[i] *= c;
    shape.crossings[i] += c > 0.0F && c < 1.0F ? 1.0F : 0.0F;
  }
}

// out = under (1 − area) + colour area
LINESERVO_CLONES void lay(const float* area, float colour, float* plane) {
  for (int i = 0; i < kTilePixels; ++i) plane[i] += (colour - plane[i]) * area[i];
}

// Where the shape covers the pixel nothing below matters; where it misses it, its borders do not.
LINESERVO_CLONES void count_crossings(const ShapeCoverage& shape, float* crossings) {
  for (std::size_t i = 0; i < kTilePixels; ++i) {
    const float below = shape.area[i] < 1.0F ? crossings[i] : 0.0F;
    crossings[i] = below + (shape.area[i] > 0.0F ? shape.crossings[i] : 0.0F);
  }
}

// Over an exposure the slope of a border hardly changes within a tile: it is taken at one instant for all,
// and divisions become products.
struct SlopePlanes {
  Plane per_F, inverse_a, inverse_2ab, knee, b;
};

inline void store(const PixelSlope& slope, std::size_t i, SlopePlanes& planes) {
  planes.per_F[i] = slope.per_F;
  planes.inverse_a[i] = 1.0F / slope.a;
  planes.inverse_2ab[i] = 1.0F / (2.0F * slope.a * slope.b);
  planes.knee[i] = 0.5F * (slope.a - slope.b);
  planes.b[i] = slope.b;
}

LINESERVO_CLONES void straight_slopes(const TileRays& rays, const ImageBorder& border, SlopePlanes& planes) {
  const PixelSlope slope = pixel_slope(border.l0.x, border.l0.y, rays.slope);
  for (std::size_t i = 0; i < kTilePixels; ++i) store(slope, i, planes);
}

LINESERVO_CLONES void round_slopes(const TileRays& rays, const ImageBorder& border, SlopePlanes& planes) {
  const LinearForm l0 = border.l0, l1 = border.l1, l2 = border.l2;
  const RayJacobian j = rays.slope;
  for (std::size_t i = 0; i < kTilePixels; ++i) {
    const float f1 = l1.at(rays.x[i], rays.y[i]), f2 = l2.at(rays.x[i], rays.y[i]);
    const float per_r = 1.0F / std::max(std::sqrt(f1 * f1 + f2 * f2), 1e-20F);
    const float F_x = (f1 * l1.x + f2 * l2.x) * per_r + l0.x, F_y = (f1 * l1.y + f2 * l2.y) * per_r + l0.y;
    store(pixel_slope(F_x, F_y, j), i, planes);
  }
}

// As covered_area().
inline float area_by_slope(float e, const SlopePlanes& planes, std::size_t i) {
  const float b = planes.b[i], t = std::abs(e), beyond = std::max(t - planes.knee[i], 0.0F);
  const float m = std::min(beyond, b);
  const float area = beyond >= b ? 0.5F : t * planes.inverse_a[i] - m * m * planes.inverse_2ab[i];
  return e >= 0.0F ? 0.5F + area : 0.5F - area;
}

LINESERVO_CLONES void straight_coverage(const TileRays& rays, const ImageBorder& border,
                                        const SlopePlanes& planes, float* coverage) {
  const LinearForm l0 = border.l0;
  for (std::size_t i = 0; i < kTilePixels; ++i)
    coverage[i] = area_by_slope(-l0.at(rays.x[i], rays.y[i]) * planes.per_F[i], planes, i);
}

LINESERVO_CLONES void round_coverage(const TileRays& rays, const ImageBorder& border,
                                     const SlopePlanes& planes, float* coverage) {
  const LinearForm l0 = border.l0, l1 = border.l1, l2 = border.l2;
  const float sign = -border.sign;
  for (std::size_t i = 0; i < kTilePixels; ++i) {
    const float f1 = l1.at(rays.x[i], rays.y[i]), f2 = l2.at(rays.x[i], rays.y[i]);
    const float F = std::sqrt(f1 * f1 + f2 * f2) + l0.at(rays.x[i], rays.y[i]);
    coverage[i] = area_by_slope(sign * F * planes.per_F[i], planes, i);
  }
}

// The instants that a tile is drawn from. A single one is drawn by the exact slope of each pixel.
struct Instants {
  const TileRays* rays;
  int count;

  const TileRays& middle() const { return rays[count / 2]; }
};

// Calls use(k, coverage) for each instant.
template <typename Use>
void border_coverages(const Instants& instants, const ImageBorder& border, Use use) {
  Plane coverage;
  if (instants.count == 1) {
    border_coverage(instants.rays[0], border, coverage);
    return use(std::size_t{0}, coverage);
  }
  SlopePlanes slopes;
  (border.is_round ? round_slopes : straight_slopes)(instants.middle(), border, slopes);
  for (int k = 0; k < instants.count; ++k) {
    if (border.is_round) {
      round_coverage(instants.rays[k], border, slopes, coverage.data());
    } else {
      straight_coverage(instants.rays[k], border, slopes, coverage.data());
    }
    use(static_cast<std::size_t>(k), coverage);
  }
}

// `layers` and `covered` hold one element for each instant.
void lay_shape(const Instants& instants, const CrossedShape& shape, ShapeCoverage* covered, Layers* layers) {
  for (int k = 0; k < instants.count; ++k) {
    covered[k].area.fill(1.0F);
    covered[k].crossings.fill(0.0F);
  }
  for (int i = 0; i < shape.border_count; ++i)
    border_coverages(instants, *shape.borders[static_cast<std::size_t>(i)],
                     [&](std::size_t k, const Plane& area) { restrict_to(area.data(), covered[k]); });
  for (int k = 0; k < instants.count; ++k) {
    for (std::size_t c = 0; c < 3; ++c)
      lay(covered[k].area.data(), static_cast<float>(shape.colour[c]), layers[k].bgr[c].data());
    count_crossings(covered[k], layers[k].crossings.data());
  }
}

constexpr std::size_t kSamples = 64;
using SamplePlane = std::array<float, kSamples>;

// Hammersley's points: no two in one column or row of 64, so that an upright border is worth 1/64 of a pixel,
// where a grid of 8 × 8 gives 1/8.
struct SamplePattern {
  SamplePlane u = {}, v = {};
};
constexpr SamplePattern hammersley() {
  SamplePattern pattern;
  for (unsigned i = 0; i < kSamples; ++i) {
    unsigned reversed = 0;
    for (unsigned bit = 0; bit < 6; ++bit) reversed |= ((i >> bit) & 1U) << (5U - bit);
    pattern.u[i] = (static_cast<float>(i) + 0.5F) / kSamples - 0.5F;
    pattern.v[i] = (static_cast<float>(reversed) + 0.5F) / kSamples - 0.5F;
  }
  return pattern;
}
constexpr SamplePattern kPattern = hammersley();

struct Samples {
  SamplePlane x, y;
  std::array<SamplePlane, 3> bgr;
};

LINESERVO_CLONES void place_samples(const TileRays& rays, std::size_t pixel, Samples& samples) {
  const RayJacobian j = rays.slope;
  const float x = rays.x[pixel], y = rays.y[pixel];
  for (std::size_t i = 0; i < kSamples; ++i) {
    samples.x[i] = x + j.x_u * kPattern.u[i] + j.x_v * kPattern.v[i];
    samples.y[i] = y + j.y_u * kPattern.u[i] + j.y_v * kPattern.v[i];
  }
}

LINESERVO_CLONES void keep_painted(const ImageBorder& border, const Samples& samples, float* painted) {
  const LinearForm l0 = border.l0, l1 = border.l1, l2 = border.l2;
  const float sign = border.sign;
  for (std::size_t i = 0; i < kSamples; ++i) {
    const float f1 = l1.at(samples.x[i], samples.y[i]), f2 = l2.at(samples.x[i], samples.y[i]);
    const float F = sign * (std::sqrt(f1 * f1 + f2 * f2) + l0.at(samples.x[i], samples.y[i]));
    painted[i] = F <= 0.0F ? painted[i] : 0.0F;
  }
}

LINESERVO_CLONES void paint_samples(const float* painted, float colour, float* plane) {
  for (std::size_t i = 0; i < kSamples; ++i) plane[i] = painted[i] > 0.0F ? colour : plane[i];
}

// Exact: a sum of at most 64 whole numbers.
float mean(const SamplePlane& plane) {
  float sum = 0.0F;
  for (const float value : plane) sum += value;
  return sum / kSamples;
}

void start_from(const BitmapView::Colour& colour, Samples& samples) {
  for (std::size_t c = 0; c < 3; ++c) samples.bgr[c].fill(colour[c]);
}

void sample_pixel(const TileRays& rays, const Cell& cell, std::size_t pixel, Layers& layers) {
  Samples samples;
  place_samples(rays, pixel, samples);
  for (std::size_t c = 0; c < 3; ++c) samples.bgr[c].fill(static_cast<float>(cell.base[c]));
  if (cell.bitmap) start_from(cell.bitmap->at(rays.x[pixel], rays.y[pixel]), samples);
  SamplePlane painted;
  for (const CrossedShape& shape : cell.shapes) {
    painted.fill(1.0F);
    for (int k = 0; k < shape.border_count; ++k)
      keep_painted(*shape.borders[static_cast<std::size_t>(k)], samples, painted.data());
    for (std::size_t c = 0; c < 3; ++c)
      paint_samples(painted.data(), static_cast<float>(shape.colour[c]), samples.bgr[c].data());
  }
  for (std::size_t c = 0; c < 3; ++c) layers.bgr[c][pixel] = mean(samples.bgr[c]);
}

void start_from(const Cell& cell, const TileRays& rays, Layers& layers) {
  auto& bgr = layers.bgr;
  if (cell.bitmap) return cell.bitmap->colours(rays, bgr[0].data(), bgr[1].data(), bgr[2].data());
  for (std::size_t c = 0; c < 3; ++c) bgr[c].fill(static_cast<float>(cell.base[c]));
}

LINESERVO_CLONES int most_crossings(const float* crossings) {
  int most = 0;
  for (std::size_t i = 0; i < kTilePixels; ++i) most = std::max(most, static_cast<int>(crossings[i]));
  return most;
}

LINESERVO_CLONES void accumulate(const float* plane, float* sum) {
  for (std::size_t i = 0; i < kTilePixels; ++i) sum[i] += plane[i];
}

LINESERVO_CLONES void scale(float factor, float* plane) {
  for (std::size_t i = 0; i < kTilePixels; ++i) plane[i] *= factor;
}

void paint_single_border(const Instants& instants, const Cell& cell, Layers& layers) {
  const CrossedShape& shape = cell.shapes.front();
  Plane mean;
  border_coverages(instants, *shape.borders[0], [&](std::size_t k, const Plane& area) {
    if (k == 0) {
      mean = area;
    } else {
      accumulate(area.data(), mean.data());
    }
  });
  if (instants.count > 1) scale(1.0F / static_cast<float>(instants.count), mean.data());
  start_from(cell, instants.middle(), layers);
  for (std::size_t c = 0; c < 3; ++c)
    lay(mean.data(), static_cast<float>(shape.colour[c]), layers.bgr[c].data());
}

// The mean ends in the first of the layers, one for each instant.
void paint_shapes(const Instants& instants, const Cell& cell, Layers* layers) {
  std::array<ShapeCoverage, ShutterOptions::kMostSamples> covered;
  for (int k = 0; k < instants.count; ++k) {
    start_from(cell, instants.rays[k], layers[k]);
    layers[k].crossings.fill(0.0F);
  }
  for (const CrossedShape& shape : cell.shapes) lay_shape(instants, shape, covered.data(), layers);
  for (int k = 0; k < instants.count; ++k) {
    if (most_crossings(layers[k].crossings.data()) <= 1) continue;
    for (std::size_t i = 0; i < kTilePixels; ++i)
      if (layers[k].crossings[i] > 1.0F) sample_pixel(instants.rays[k], cell, i, layers[k]);
  }
  if (instants.count == 1) return;
  for (std::size_t c = 0; c < 3; ++c) {
    for (int k = 1; k < instants.count; ++k) accumulate(layers[k].bgr[c].data(), layers[0].bgr[c].data());
    scale(1.0F / static_cast<float>(instants.count), layers[0].bgr[c].data());
  }
}

}  // namespace

void paint_tile(const TileRays& rays, const Cell& cell, TilePixels& bgr) {
  paint_tile(&rays, 1, cell, bgr);
}

void paint_tile(const TileRays* rays, int count, const Cell& cell, TilePixels& bgr) {
  const Instants instants{rays, count};
  std::array<Layers, ShutterOptions::kMostSamples> layers;
  if (cell.has_single_border()) {
    paint_single_border(instants, cell, layers[0]);
  } else {
    paint_shapes(instants, cell, layers.data());
  }
  interleave(layers[0].bgr[0], layers[0].bgr[1], layers[0].bgr[2], bgr);
}

}  // namespace lineservo::vehicle
