#include "apps/report/tick_rows.h"

#include "apps/flight/convert.h"
#include "apps/scoring/junction_score.h"
#include "apps/scoring/track_score.h"

namespace lineservo::apps {
namespace {

/// Adds to each row the sample of its own time: the last of the truth period before it.
void add_errors(std::vector<TickRow>& rows, const std::vector<TrackSample>& samples) {
  auto next = samples.begin();
  for (TickRow& row : rows) {
    while (next != samples.end() && next->t <= row.tick->t) ++next;
    if (next == samples.begin()) continue;
    const TrackSample& last = *(next - 1);
    if (row.tick->t - last.t >= kTruthPeriod) continue;
    row.error_m = last.signed_m;
    row.leg = static_cast<int>(last.leg);
    row.turning = last.turning;
  }
}

}  // namespace

std::vector<TickRow> tick_rows(const Mission& mission, const FlightRecord& record, const RouteTruth& route) {
  const CameraSettings& camera = mission.request.settings.camera;
  const JunctionTruth truth(mission.floor, features::CameraModel(camera_parameters(camera)));
  std::vector<TickRow> rows;
  for (const TickRecord& tick : record.ticks) {
    TickRow& row = rows.emplace_back(TickRow{&tick});
    const auto code = scored_truth(tick, truth, 1.0 / camera.frame_rate_hz);
    if (code) row.true_code = static_cast<int>(code->accepts(tick.code.raw) ? tick.code.raw : code->code);
  }
  add_errors(rows, track_samples(record, route));
  return rows;
}

}  // namespace lineservo::apps
