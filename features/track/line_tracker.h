#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

#include "features/frame_features.h"

namespace lineservo::features {

/// Noise, gates and memory of the Kalman filter over the line to follow.
struct LineTrackerOptions {
  double offset_acceleration_m_s2 = 1.0;   ///< standard deviation of the process noise, across the line
  double angle_acceleration_rad_s2 = 2.0;  ///< of the heading against the line
  double gate = 13.8;                   ///< of the squared Mahalanobis distance: χ² with 2 degrees, 99.9 %
  double least_offset_sigma_m = 0.002;  ///< a detector's covariance is never trusted below this
  double least_angle_sigma_rad = 0.003;
  double let_go_rad =
      1.05;  ///< |θ| beyond which the line leads elsewhere and is let go: after a turn another one counts
  double memory_s = 0.5;  ///< how long a line that is not seen is predicted
};

/// A line as the filter has it.
struct TrackedLine {
  LineFeature line;        ///< filtered (ρ, θ) and their covariance; the rest as last seen
  bool predicted = false;  ///< not seen in this frame
};

/// Follows one line from frame to frame (grid §V, §VI-B): a Kalman filter with constant velocity on the
/// offset in metres (ρ times the height, so that climbing does not move the line) and on θ, wrap handled,
/// innovation gated. Of several lines in view it takes the one most like its prediction: the goal line stays
/// the goal line.
class LineTracker {
 public:
  /// Throws std::invalid_argument for options out of bounds.
  explicit LineTracker(const LineTrackerOptions& options = {});

  void reset() { has_line_ = false; }

  /// One frame on: `dt_s` since the frame before, the height, and the lines seen, best to follow first. The
  /// first line starts the track. None when nothing is tracked, or when it was last seen longer than the
  /// memory ago.
  std::optional<TrackedLine> update(double dt_s, double height_m, std::span<const LineFeature> lines);

  /// The line that the filter expects at this height, for a detector's prior; none when nothing is tracked.
  std::optional<LineFeature> expected(double height_m) const;

 private:
  using State = Eigen::Vector4d;  // offset_m, its rate, θ, its rate
  struct Match {
    const LineFeature* line = nullptr;
    Eigen::Vector2d innovation = Eigen::Vector2d::Zero();
    Eigen::Matrix2d inverse = Eigen::Matrix2d::Zero();
  };

  void start(const LineFeature& line, double height_m);
  void predict(double dt_s);
  bool leads_elsewhere(double theta_rad) const;
  std::optional<Match> best_match(std::span<const LineFeature> lines, double height_m) const;
  void correct(const Match& match);
  Eigen::Matrix2d noise(const LineFeature& line, double height_m) const;

  LineTrackerOptions options_;
  bool has_line_ = false;
  State state_ = State::Zero();
  Eigen::Matrix4d covariance_ = Eigen::Matrix4d::Identity();
  LineFeature seen_;
  double unseen_s_ = 0.0;
};

}  // namespace lineservo::features
