#include "features/point/virtual_target.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "features/geometry/angles.h"

namespace lineservo::features {
namespace {

/// Of the path, relative to the image centre.
struct RingPixel {
  double dx, dy;
  double direction_rad;
};

void require(const ArcMask& arc) {
  if (!(arc.inner_px > 0.0 && arc.inner_px <= arc.outer_px))
    throw std::invalid_argument("arc mask: the radii must hold 0 < inner <= outer");
  if (!(arc.half_angle_rad > 0.0 && arc.half_angle_rad <= kPi))
    throw std::invalid_argument("arc mask: the half-angle must be in (0, π]");
}

std::vector<RingPixel> on_ring(const PackedMask& path, const ArcMask& arc) {
  const double cx = 0.5 * (path.width() - 1), cy = 0.5 * (path.height() - 1);
  std::vector<RingPixel> ring;
  for (int y = 0; y < path.height(); ++y) {
    for (int x = 0; x < path.width(); ++x) {
      const double dx = x - cx, dy = y - cy, radius_px = std::hypot(dx, dy);
      if (radius_px < arc.inner_px || radius_px > arc.outer_px || !path.at(x, y)) continue;
      ring.push_back({dx, dy, std::atan2(-dx, -dy)});
    }
  }
  return ring;
}

double nearest_to_up(const std::vector<RingPixel>& ring) {
  return std::min_element(ring.begin(), ring.end(),
                          [](const RingPixel& a, const RingPixel& b) {
                            return std::abs(a.direction_rad) < std::abs(b.direction_rad);
                          })
      ->direction_rad;
}

}  // namespace

std::optional<VirtualTarget> virtual_target(const PackedMask& path, std::optional<double> previous_rad,
                                            const ArcMask& arc) {
  require(arc);
  const std::vector<RingPixel> ring = on_ring(path, arc);
  if (ring.empty()) return std::nullopt;
  const double about_rad = previous_rad ? *previous_rad : nearest_to_up(ring);
  double dx = 0.0, dy = 0.0;
  int pixels = 0;
  for (const RingPixel& pixel : ring) {
    if (std::abs(wrap_angle(pixel.direction_rad - about_rad)) > arc.half_angle_rad) continue;
    dx += pixel.dx;
    dy += pixel.dy;
    ++pixels;
  }
  if (pixels == 0) return std::nullopt;
  dx /= pixels;
  dy /= pixels;
  return VirtualTarget{{dx + 0.5 * (path.width() - 1), dy + 0.5 * (path.height() - 1)}, std::atan2(-dx, -dy)};
}

}  // namespace lineservo::features
