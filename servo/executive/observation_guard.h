#pragma once

#include <optional>
#include <string>

#include "servo/law/observation.h"

namespace lineservo::servo {

/// All numbers of perception, or of the estimates, are finite.
bool is_finite(const features::FrameFeatures& features);
bool is_finite(const StateEstimate& estimate);

/// The door of the executive: what comes through is finite. A feature that is not counts as not seen; the
/// last good estimates stand in for bad ones, for as long as bad_for_s() says.
class ObservationGuard {
 public:
  /// The observation, or a copy that is sound; valid until the next call.
  const Observation& checked(const Observation& observation);
  /// For how long the estimates have been bad.
  double bad_for_s() const { return bad_for_s_; }
  /// What has just begun to be wrong, once.
  std::optional<std::string> take_news();

 private:
  Observation sound_;
  std::optional<Time> bad_since_;
  double bad_for_s_ = 0.0;
  bool features_bad_ = false;
  std::optional<std::string> news_;
};

}  // namespace lineservo::servo
