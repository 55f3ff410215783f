#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "apps/evaluate/line_frames.h"
#include "apps/evaluate/line_score.h"

namespace lineservo::apps {

/// Which line methods look at which frames, and how many.
struct LineEvaluationOptions {
  int frames = 100;  ///< of each level and size
  std::uint64_t seed = 1;
  std::vector<std::string> methods = {};  ///< empty: all
  std::vector<std::string> levels = {};   ///< empty: all
  double empty_share = kEmptyShare;       ///< of the frames that show no line, 0…1
};

/// One row of the table.
struct LineEvaluationRow {
  std::string method;
  bool told_tilt = false;  ///< the method was given the camera and its tilt
  FrameLevel level = FrameLevel::clean;
  cv::Size size;
  LineScore score;
};

/// Runs methods over generated frames of every level and both sizes (grid Tab. II used 1920×1080). Methods
/// that can use the camera run twice: told its tilt, and on the image alone. All see the same pictures.
/// `progress` is called with the share done; when it returns false the evaluation ends with what it has.
/// Throws std::invalid_argument for an unknown method or level, frames outside 1…100000 or
/// a share outside 0…1.
std::vector<LineEvaluationRow> evaluate_lines(const LineEvaluationOptions& options,
                                              const std::function<bool(double)>& progress);

}  // namespace lineservo::apps
