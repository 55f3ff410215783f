#pragma once

#include <optional>

#include "servo/law/observation.h"

namespace lineservo::servo {

/// Holds a straight edge's heading, so that where two branches look alike the one that goes straight on is
/// followed. Headings are of the dead reckoning.
class LegCompass {
 public:
  /// What counts as the line of the leg, and how fast its heading is learnt.
  struct Options {
    double off_rad = features::radians(14.0);  ///< what lies further off the heading is another line
    double time_constant_s = 20.0;             ///< with which the heading follows the line: the gyro drifts
  };
  LegCompass() : LegCompass(Options{}) {}
  explicit LegCompass(const Options& options) : options_(options) {}

  /// At the beginning of an edge.
  void restart() {
    heading_rad_.reset();
    off_for_s_ = 0.0;
  }
  /// Takes in a frame on a straight edge. The index of the line that goes straight on: 0 unless the first one
  /// turns off and another one does not.
  std::size_t straight_on(const Observation& observation);
  /// For how long the line that is followed has been turning off.
  double off_for_s() const { return off_for_s_; }

 private:
  double off_rad(const Observation& observation, const features::LineFeature& line) const;

  Options options_;
  std::optional<double> heading_rad_;
  Time last_{0};
  double off_for_s_ = 0.0;
};

}  // namespace lineservo::servo
