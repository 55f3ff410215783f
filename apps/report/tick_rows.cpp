#include "apps/report/tick_rows.h"

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

std::vector<TickRow> tick_rows(const FlightRecord& record, const RouteTruth& route,
                               const JunctionScore& junctions) {
  std::vector<TickRow> rows;
  for (std::size_t k = 0; k < record.ticks.size(); ++k) {
    TickRow& row = rows.emplace_back(TickRow{&record.ticks[k]});
    row.true_code = junctions.true_codes.at(k);
  }
  add_errors(rows, track_samples(record, route));
  return rows;
}

}  // namespace lineservo::apps
