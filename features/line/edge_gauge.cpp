#include "features/line/edge_gauge.h"

#include <algorithm>
#include <cmath>

namespace lineservo::features {
namespace {

constexpr double kLeastRise = 1.0 / 3.0;  // of the colours' difference: the same floor in deep shade
constexpr int kMaxReach_px = 24;

}  // namespace

EdgeGauge::EdgeGauge(const cv::Mat& image, const Eigen::Vector3d& paint_minus_floor)
    : image_(image), mix_(paint_minus_floor.normalized()), contrast_(paint_minus_floor.norm()) {}

double EdgeGauge::mixed(int x, int y) const {
  if (image_.channels() == 1) return mix_[0] * image_.ptr<std::uint8_t>(y)[x];
  const std::uint8_t* bgr = image_.ptr<std::uint8_t>(y) + 3 * x;
  return mix_[0] * bgr[0] + mix_[1] * bgr[1] + mix_[2] * bgr[2];
}

double EdgeGauge::value(double x, double y) const {
  const int x0 = std::clamp(static_cast<int>(x), 0, image_.cols - 2);
  const int y0 = std::clamp(static_cast<int>(y), 0, image_.rows - 2);
  const double fx = x - x0, fy = y - y0;
  const double top = mixed(x0, y0) * (1.0 - fx) + mixed(x0 + 1, y0) * fx;
  const double bottom = mixed(x0, y0 + 1) * (1.0 - fx) + mixed(x0 + 1, y0 + 1) * fx;
  return top * (1.0 - fy) + bottom * fy;
}

bool EdgeGauge::in_view(const PixelPoint& at, const Eigen::Vector2d& into_paint, int reach_px) const {
  const double dx = reach_px * std::abs(into_paint.x()), dy = reach_px * std::abs(into_paint.y());
  return at.x - dx >= 0.0 && at.y - dy >= 0.0 && at.x + dx <= image_.cols - 1.0 &&
         at.y + dy <= image_.rows - 1.0;
}

// Samples s₋R … s_R with plateaus a (floor) and b (paint): Σ (s − a)/(b − a) is the length of paint, and the
// profile is 2R + 1 long, so the edge lies at R + ½ − Σ.
std::optional<double> EdgeGauge::locate(const PixelPoint& at, const Eigen::Vector2d& into_paint,
                                        int reach_px) const {
  const int reach = std::min(reach_px, kMaxReach_px), plateau = std::max(1, reach / 3);
  if (!in_view(at, into_paint, reach)) return std::nullopt;
  double sum = 0.0, floor = 0.0, paint = 0.0;
  const int samples = 2 * reach + 1;
  for (int k = 0; k < samples; ++k) {
    const double s = value(at.x + (k - reach) * into_paint.x(), at.y + (k - reach) * into_paint.y());
    sum += s;
    if (k < plateau) floor += s / plateau;
    if (k >= samples - plateau) paint += s / plateau;
  }
  const double rise = paint - floor;
  if (rise < kLeastRise * contrast_) return std::nullopt;
  const double offset = reach + 0.5 - (sum - samples * floor) / rise;
  if (std::abs(offset) > reach - plateau) return std::nullopt;
  return offset;
}

}  // namespace lineservo::features
