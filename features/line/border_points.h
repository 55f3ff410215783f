#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "features/mask/level_mask.h"

namespace lineservo::features {

/// A point where paint meets bare floor, in the virtual level camera.
struct BorderPoint {
  Eigen::Vector2d p_L;
  Eigen::Vector2d normal;  ///< unit, into the paint
  double theta_rad;        ///< of the normal's axis, in [−π/2, π/2], to about 0.3°
  double length;           ///< of the border that this point stands for, normalised units
};

/// How densely a mask is scanned for the borders of the paint.
struct BorderOptions {
  int stride_px = 4;              ///< every so many rows and columns are scanned: 1, 2, 4 or 8
  int max_crossings_a_line = 48;  ///< a scan line that toggles more often than this holds noise, not paint
  int min_links = 2;              ///< a point needs a chain of so many links, or it has no direction
};

/// Finds where rows and columns of a mask cross the border of the paint. The frame of the image is no border.
/// Keeps its buffers from call to call.
class BorderExtractor {
 public:
  /// Throws std::invalid_argument for options out of bounds.
  explicit BorderExtractor(const BorderOptions& options = {});

  /// Replaces `points` by the border points of the mask.
  void extract(const LevelMask& mask, std::vector<BorderPoint>& points);

 private:
  /// A place where a scan line toggles, linked to the same border on the scan lines before and after.
  struct Crossing {
    int position_px;  ///< along the scan line: between this pixel and the one before
    bool into_paint;
    int previous, next;  ///< itself where the chain ends
    Eigen::Vector2d p_L = {0.0, 0.0};
  };
  /// The crossings of one family of parallel scan lines, in order, line after line.
  struct Family {
    std::vector<std::uint16_t> raw;  ///< position · 2 + into_paint, `max_crossings_a_line` slots a line
    std::vector<int> count;
    std::vector<int> first;  ///< of each line's crossings; one more than there are lines
    std::vector<Crossing> crossings;
  };

  void reset(Family& family, int lines) const;
  void add(Family& family, int line, int position_px, bool into_paint) const;
  void scan_rows(const MaskView& mask);
  void scan_columns(const MaskView& mask);
  void flatten(Family& family) const;
  static void link(Family& family, int reach_px);
  void emit(const Family& family, int axis, double spacing, std::vector<BorderPoint>& points) const;

  BorderOptions options_;
  Family rows_, columns_;
};

}  // namespace lineservo::features
