#pragma once

#include <array>
#include <cstddef>

#include "vehicle/estimate.h"
#include "vehicle/sensors/sensor_parameters.h"

namespace lineservo::vehicle {

/// The estimates of the last second, to answer for the time at which a picture was taken.
class EstimateHistory {
 public:
  /// Estimates come in order of time, one every kInertialPeriod.
  void add(const Estimate& estimate);
  /// Linear between the two nearest in time; the first or last one beyond the ends.
  Estimate at(Time t) const;
  const Estimate& newest() const { return ring_[(added_ - 1) % kSize]; }

 private:
  static constexpr std::size_t kSize = std::chrono::seconds(1) / kInertialPeriod + 1;
  std::array<Estimate, kSize> ring_{};
  std::size_t added_ = 0;
};

/// The estimate the share w on the way from a to b.
Estimate interpolated(const Estimate& a, const Estimate& b, double w);

}  // namespace lineservo::vehicle
