#include "apps/scoring/safety.h"

#include <algorithm>

#include "vehicle/floor/floor_truth.h"

namespace lineservo::apps {
namespace {

constexpr std::size_t kStride = 10;  // of the samples: every 0.1 s

std::string end_of(const FlightRecord& record) {
  if (record.crashed) return "crash";
  if (record.landed) return "ground";
  return record.last_phase == servo::Phase::finished ? "hover" : "air";
}

}  // namespace

Safety assess_safety(const FlightRecord& record, const vehicle::Layout& floor) {
  Safety safety;
  safety.ends = end_of(record);
  for (std::size_t i = 0; i < record.truth.size(); i += kStride) {
    const Eigen::Vector2d p_W = record.truth[i].p_WB.head<2>();
    safety.paint_distance_m = std::max(safety.paint_distance_m, vehicle::distance_to_paint_m(floor, p_W));
  }
  if (record.abort_reason != servo::AbortReason::none) safety.reason = servo::name(record.abort_reason);
  return safety;
}

}  // namespace lineservo::apps
