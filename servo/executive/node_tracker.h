#pragma once

#include <Eigen/Core>
#include <optional>

#include "servo/law/observation.h"

namespace lineservo::servo {

/// Follows the centre of one node from frame to frame, over dead reckoning while it is not seen.
class NodeTracker {
 public:
  /// Which sightings are of the node that is remembered, and how long it is.
  struct Options {
    double gate_m = 0.25;   ///< a sighting further from the prediction is another node
    double jump_m = 0.03;   ///< a sighting further from the prediction counts when the next one agrees
    double memory_s = 1.0;  ///< after which a node that was not seen is forgotten
    double weight = 0.5;    ///< of a new sighting against the prediction
  };
  explicit NodeTracker(const Options& options) : options_(options) {}

  void reset() {
    node_O_.reset();
    jumped_to_O_.reset();
  }
  /// A sighting at the frame's capture, heading frame of that instant, metres; none is allowed.
  /// False when it does not count.
  bool observe(const Observation& observation, const std::optional<Eigen::Vector2d>& sighting_m);
  /// The node's centre now, heading frame; none when nothing is tracked.
  std::optional<Eigen::Vector2d> node_now(const Observation& observation) const;
  /// The same as it was when the frame was taken.
  std::optional<Eigen::Vector2d> node_at_capture(const Observation& observation) const;

 private:
  bool jumps(const Eigen::Vector2d& sighting_O);

  Options options_;
  std::optional<Eigen::Vector2d> node_O_;       ///< in the frame where odometry began
  std::optional<Eigen::Vector2d> jumped_to_O_;  ///< by the last sighting, if it did
  Time seen_{0};
};

}  // namespace lineservo::servo
