#pragma once

#include <optional>
#include <vector>

#include "features/line/image_line.h"

namespace lineservo::apps {

/// A found line counts as right within these.
inline constexpr double kFoundWithin_px = 20.0;
inline constexpr double kFoundWithin_deg = 3.0;

/// Mean, median and 95th percentile (nearest rank) of sizes; NaN where there are none.
struct ErrorSummary {
  double mean, median, p95;
};
ErrorSummary summarise_errors(std::vector<double> sizes);

/// The 95 % interval of a share of which `hits` of `trials` were seen (Wilson 1927); NaN without trials.
struct ShareInterval {
  double low, high;
};
ShareInterval wilson_interval(int hits, int trials);

/// How one method did on a series of frames.
struct LineScore {
  int frames_with_line = 0, answered = 0, found = 0;
  int frames_without_line = 0, false_alarms = 0;
  std::vector<double> rho_px, theta_deg;  ///< |Δρ| and |Δθ| of every answer to a frame with a line
  double time_ms = 0.0, mask_ms = 0.0;    ///< of all frames together

  int frames() const { return frames_with_line + frames_without_line; }
  double detection_rate() const;    ///< found of the frames with a line; NaN without any
  double false_alarm_rate() const;  ///< of the frames without a line; NaN without any
  double time_per_frame_ms() const { return time_ms / frames(); }
  double mask_per_frame_ms() const { return mask_ms / frames(); }

  void add(const std::optional<features::ImageLine>& truth, const std::optional<features::ImageLine>& answer);
};

}  // namespace lineservo::apps
