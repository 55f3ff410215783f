#include "apps/scoring/junction_score.h"

#include <limits>
#include <optional>

namespace lineservo::apps {
namespace {

Eigen::Isometry3d pose(const TruthSample& s) {
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  X_WB.linear() = (Eigen::AngleAxisd(s.heading_rad, Eigen::Vector3d::UnitZ()) *
                   Eigen::AngleAxisd(s.pitch_rad, Eigen::Vector3d::UnitY()) *
                   Eigen::AngleAxisd(s.roll_rad, Eigen::Vector3d::UnitX()))
                      .toRotationMatrix();
  X_WB.translation() = s.p_WB;
  return X_WB;
}

std::size_t index(features::JunctionCode code) {
  return static_cast<std::size_t>(code);
}

/// What the frame of a tick truly showed; none where it is not scored.
std::optional<CodeTruth> scored_truth(const TickRecord& tick, const JunctionTruth& truth,
                                      double frame_period_s) {
  if (tick.at_capture.phase != servo::Phase::follow || tick.now.phase != servo::Phase::follow)
    return std::nullopt;
  if (!tick.has_frame) return std::nullopt;
  const double travel_m = tick.at_capture.v_W.head<2>().norm() * frame_period_s;
  CodeTruth code = truth.at(pose(tick.at_capture), travel_m);
  return code.scored ? std::optional(std::move(code)) : std::nullopt;
}

}  // namespace

double JunctionScore::accuracy(long wrong) const {
  if (frames == 0) return std::numeric_limits<double>::quiet_NaN();
  return 1.0 - static_cast<double>(wrong) / static_cast<double>(frames);
}

JunctionScore score_junctions(const FlightRecord& record, const JunctionTruth& truth, double frame_period_s) {
  JunctionScore score;
  for (const TickRecord& tick : record.ticks) {
    const std::optional<CodeTruth> code = scored_truth(tick, truth, frame_period_s);
    score.true_codes.push_back(JunctionScore::kNotScored);
    if (!code) continue;
    ++score.frames;
    score.ambiguous += code->ambiguous() ? 1 : 0;
    score.misclassified += code->accepts(tick.code.raw) ? 0 : 1;
    score.held_wrong += code->accepts(tick.code.held) ? 0 : 1;
    score.smoothed_wrong += code->accepts(tick.code.smoothed) ? 0 : 1;
    const features::JunctionCode true_code = code->accepts(tick.code.raw) ? tick.code.raw : code->code;
    score.true_codes.back() = static_cast<std::int8_t>(true_code);
    ++score.confusion[index(true_code)][index(tick.code.raw)];
  }
  score.events_right = record.steps_done;
  score.events = record.steps_done + (record.abort_reason == servo::AbortReason::node_unexpected ||
                                              record.abort_reason == servo::AbortReason::node_overdue
                                          ? 1
                                          : 0);
  return score;
}

}  // namespace lineservo::apps
