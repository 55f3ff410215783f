#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "apps/flight/flight_record.h"
#include "apps/scoring/route_truth.h"

namespace lineservo::apps {

/// Statistics of the offset from the centreline, metres; NaN while there is no sample.
struct OffsetStatistics {
  double rmse_m, max_m, mae_m, std_m, mean_m;
};

/// One leg of apps/results.md. Its error is the distance of the true body origin to the true centreline;
/// during the turn that ends it, to the nearer of the two edges, each ending at the node.
struct LegScore {
  std::string from, to, axis;
  OffsetStatistics whole;
  double settled_rmse_m;  ///< more than 5 s after the leg's start and outside turns
  double turn_max_m;      ///< in the turn that ends the leg, and in the first 5 s when a turn began it
  long samples = 0;
};

/// How often the error fell into each bin of 5 cm; the last bin has no upper end.
inline constexpr double kErrorBin_m = 0.05;
using ErrorDistribution = std::array<long, 20>;

/// The same with its sign in bins of 5 mm about zero; the first and the last bin have no outer end.
inline constexpr double kSignedErrorBin_m = 0.005;
using SignedDistribution = std::array<long, 242>;

/// How a flight kept to its lines, leg by leg and over all.
struct TrackScore {
  std::vector<LegScore> legs;  ///< those that were begun
  OffsetStatistics all;
  double settled_rmse_m, turn_max_m, p95_m;  ///< of all legs
  ErrorDistribution distribution{};
  SignedDistribution signed_distribution{};
};

/// The error at one sample of the true state.
struct TrackSample {
  vehicle::Time t{0};
  std::size_t leg = 0;
  double signed_m = 0.0;  ///< positive to the left of travel
  bool turning = false;   ///< the turn that ends the leg is on
  double since_leg_began_s = 0.0;
};

/// Those samples that count, in order: none before the first leg, none at a target.
std::vector<TrackSample> track_samples(const FlightRecord& record, const RouteTruth& route);

TrackScore score_track(const FlightRecord& record, const RouteTruth& route);

/// Rest of 2 s under 0.03 m/s in dock or hover at a target.
struct Rest {
  double x_m, y_m, heading_rad;  ///< mean
  double target_error_m;         ///< mean distance to the target
  double target_max_m;
  double until_s = 0.0;  ///< the end of it
};

inline constexpr double kRestSpeed_m_s = 0.03;
inline constexpr double kRestTime_s = 2.0;
inline constexpr double kArrivalRadius_m = 0.3;

/// The first such rest at a step of the plan, or none.
std::optional<Rest> find_rest(const FlightRecord& record, int step, const Eigen::Vector2d& target_W);

}  // namespace lineservo::apps
