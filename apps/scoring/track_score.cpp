#include "apps/scoring/track_score.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "apps/scoring/percentile.h"
#include "features/geometry/angles.h"

namespace lineservo::apps {
namespace {

using features::wrap_angle;
using servo::Phase;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kSettles_s = 5.0;
constexpr double kTurnEnds_rad = features::radians(3.0);

/// Sums up offsets as they come.
class OffsetSums {
 public:
  void add(double signed_m) {
    ++count_;
    sum_ += signed_m;
    absolute_ += std::abs(signed_m);
    squares_ += signed_m * signed_m;
    max_ = std::max(max_, std::abs(signed_m));
  }
  long count() const { return count_; }
  double rmse() const { return count_ == 0 ? kNaN : std::sqrt(squares_ / n()); }
  double max() const { return count_ == 0 ? kNaN : max_; }
  OffsetStatistics statistics() const {
    if (count_ == 0) return {kNaN, kNaN, kNaN, kNaN, kNaN};
    const double mean = sum_ / n();
    return {rmse(), max_, absolute_ / n(), std::sqrt(std::max(0.0, squares_ / n() - mean * mean)), mean};
  }

 private:
  double n() const { return static_cast<double>(count_); }
  long count_ = 0;
  double sum_ = 0.0, absolute_ = 0.0, squares_ = 0.0, max_ = 0.0;
};

struct LegSums {
  OffsetSums whole, settled, turn;
};

std::size_t error_bin(double error_m) {
  const auto bin = static_cast<std::size_t>(error_m / kErrorBin_m);
  return std::min(bin, ErrorDistribution{}.size() - 1);
}

std::size_t signed_error_bin(double signed_m) {
  const auto inner = static_cast<double>(SignedDistribution{}.size() - 2);
  const double bin = std::floor(signed_m / kSignedErrorBin_m + 0.5 * inner);
  return static_cast<std::size_t>(std::clamp(bin, -1.0, inner) + 1.0);
}

/// Walks along the true states, knows the leg and whether a turn is on.
class LegWalker {
 public:
  explicit LegWalker(const RouteTruth& route) : route_(route) {}

  /// None where it does not count.
  std::optional<TrackSample> take(const TruthSample& s) {
    if (!begun_) begun_ = begin(s);
    if (!begun_ || is_over(s)) return std::nullopt;
    if (ends_leg(s)) {
      ++leg_;
      leg_began_ = s.t;
    }
    const bool turning = is_turning(s);
    return TrackSample{s.t, leg_, signed_error_m(s, turning), turning, vehicle::seconds(s.t - leg_began_)};
  }

 private:
  bool begin(const TruthSample& s) {
    if (s.phase != Phase::follow) return false;
    leg_began_ = s.t;
    return true;
  }

  /// What is done at a target does not count, nor the flight's end: hovering, looking, landing, giving up.
  static bool is_over(const TruthSample& s) {
    return s.phase == Phase::hover || s.phase == Phase::land || s.phase == Phase::aborted ||
           s.phase == Phase::finished || s.phase == Phase::look || s.phase == Phase::rest ||
           s.phase == Phase::relaunch;
  }

  bool is_turning(const TruthSample& s) const {
    if (leg_ + 1 >= route_.legs.size() || s.step != route_.closing_steps[leg_]) return false;
    const bool docks_to_turn = s.phase == Phase::dock && !route_.closed_by_stop[leg_];
    return docks_to_turn || s.phase == Phase::corner || s.phase == Phase::turn;
  }

  /// The turn has come within 3° of the next edge, or the plan has gone on all the same.
  bool ends_leg(const TruthSample& s) const {
    if (leg_ + 1 >= route_.legs.size()) return false;
    if (s.step > route_.closing_steps[leg_]) return true;
    const double off_rad = wrap_angle(s.heading_rad - route_.legs[leg_ + 1].start_heading_rad);
    return is_turning(s) && std::abs(off_rad) < kTurnEnds_rad;
  }

  double signed_error_m(const TruthSample& s, bool turning) const {
    const Eigen::Vector2d p_W = s.p_WB.head<2>();
    LegOffset offset = offset_from(route_.legs[leg_], p_W);
    if (turning) {
      const LegOffset next = offset_after_node(route_.legs[leg_ + 1], p_W);
      if (next.distance_m < offset.distance_m) offset = next;
    }
    return std::copysign(offset.distance_m, offset.signed_m);
  }

  const RouteTruth& route_;
  std::size_t leg_ = 0;
  bool begun_ = false;
  vehicle::Time leg_began_{0};
};

void add(LegSums& sums, const TrackSample& s) {
  const bool early = s.since_leg_began_s <= kSettles_s;
  sums.whole.add(s.signed_m);
  if (!s.turning && !early) sums.settled.add(s.signed_m);
  if (s.turning || (early && s.leg > 0)) sums.turn.add(s.signed_m);
}

std::vector<LegScore> leg_scores(const std::vector<LegSums>& sums, const RouteTruth& route) {
  std::vector<LegScore> scores;
  for (std::size_t k = 0; k < sums.size(); ++k) {
    if (sums[k].whole.count() == 0) continue;
    const LegTruth& leg = route.legs[k];
    scores.push_back({leg.from, leg.to, leg.axis, sums[k].whole.statistics(), sums[k].settled.rmse(),
                      sums[k].turn.max(), sums[k].whole.count()});
  }
  return scores;
}

bool may_rest(const TruthSample& s, int step) {
  return s.step == step && (s.phase == Phase::hover || s.phase == Phase::finished || s.phase == Phase::dock);
}

Rest summarise(const std::vector<TruthSample>& truth, std::size_t first, std::size_t last,
               const Eigen::Vector2d& target) {
  Rest rest{0, 0, 0, 0, 0, vehicle::seconds(truth[last - 1].t)};
  const double n = static_cast<double>(last - first);
  for (std::size_t i = first; i < last; ++i) {
    const double distance_m = (truth[i].p_WB.head<2>() - target).norm();
    rest.x_m += truth[i].p_WB.x() / n;
    rest.y_m += truth[i].p_WB.y() / n;
    rest.heading_rad += wrap_angle(truth[i].heading_rad - truth[first].heading_rad) / n;
    rest.target_error_m += distance_m / n;
    rest.target_max_m = std::max(rest.target_max_m, distance_m);
  }
  rest.heading_rad = wrap_angle(rest.heading_rad + truth[first].heading_rad);
  return rest;
}

}  // namespace

std::vector<TrackSample> track_samples(const FlightRecord& record, const RouteTruth& route) {
  LegWalker walker(route);
  std::vector<TrackSample> samples;
  for (const TruthSample& state : record.truth) {
    if (const auto sample = walker.take(state)) samples.push_back(*sample);
  }
  return samples;
}

TrackScore score_track(const FlightRecord& record, const RouteTruth& route) {
  TrackScore score;
  std::vector<LegSums> legs(route.legs.size());
  LegSums all;
  std::vector<double> errors_m;
  for (const TrackSample& sample : track_samples(record, route)) {
    for (LegSums* sums : {&legs[sample.leg], &all}) add(*sums, sample);
    errors_m.push_back(std::abs(sample.signed_m));
    ++score.distribution[error_bin(errors_m.back())];
    ++score.signed_distribution[signed_error_bin(sample.signed_m)];
  }
  score.legs = leg_scores(legs, route);
  score.all = all.whole.statistics();
  score.settled_rmse_m = all.settled.rmse();
  score.turn_max_m = all.turn.max();
  score.p95_m = percentile(errors_m, 0.95);
  return score;
}

std::optional<Rest> find_rest(const FlightRecord& record, int step, const Eigen::Vector2d& target_W) {
  const auto needed = static_cast<std::size_t>(kRestTime_s / vehicle::seconds(kTruthPeriod));
  std::size_t still = 0;
  for (std::size_t i = 0; i < record.truth.size(); ++i) {
    const TruthSample& s = record.truth[i];
    still = may_rest(s, step) && s.v_W.norm() < kRestSpeed_m_s ? still + 1 : 0;
    if (still == needed) return summarise(record.truth, i + 1 - needed, i + 1, target_W);
  }
  return std::nullopt;
}

}  // namespace lineservo::apps
