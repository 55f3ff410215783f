#pragma once

#include <Eigen/Core>

#include "apps/flight/flight_record.h"

namespace lineservo::apps {

/// How well a vehicle held its place: distances to the target of a step over the whole phase *hover* there,
/// metres; NaN without it.
struct HoldScore {
  double mean_m, max_m;
};
HoldScore score_hold(const FlightRecord& record, int step, const Eigen::Vector2d& target_W);

/// Control effort: the root mean square of the tilt rate √(p² + q²) from the first *follow* on, in follow,
/// turn, dock and hover; NaN when there was none.
double tilt_rate_rms_rad_s(const FlightRecord& record);

}  // namespace lineservo::apps
