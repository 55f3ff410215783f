#include "apps/scoring/hold_score.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lineservo::apps {
namespace {

using servo::Phase;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

bool is_under_way(const TruthSample& s) {
  return s.phase == Phase::follow || s.phase == Phase::corner || s.phase == Phase::turn ||
         s.phase == Phase::dock || s.phase == Phase::hover;
}

}  // namespace

HoldScore score_hold(const FlightRecord& record, int step, const Eigen::Vector2d& target_W) {
  double sum_m = 0.0, max_m = 0.0;
  long count = 0;
  for (const TruthSample& s : record.truth) {
    if (s.phase != Phase::hover || s.step != step) continue;
    const double distance_m = (s.p_WB.head<2>() - target_W).norm();
    sum_m += distance_m;
    max_m = std::max(max_m, distance_m);
    ++count;
  }
  if (count == 0) return {kNaN, kNaN};
  return {sum_m / static_cast<double>(count), max_m};
}

double tilt_rate_rms_rad_s(const FlightRecord& record) {
  double squares = 0.0;
  long count = 0;
  for (const TruthSample& s : record.truth) {
    if (!is_under_way(s)) continue;
    squares += s.w_B.head<2>().squaredNorm();
    ++count;
  }
  return count == 0 ? kNaN : std::sqrt(squares / static_cast<double>(count));
}

}  // namespace lineservo::apps
