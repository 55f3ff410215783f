#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

#include "features/line/line_detector.h"
#include "vehicle/random.h"

namespace lineservo::apps {

/// How much a generated frame suffers.
enum class FrameLevel {
  clean,      ///< paint on a plain floor, nothing else
  real_like,  ///< noise σ 3, blur up to 1.2 px, light 0.75…1.2, worn paint (5 %), short gaps, JPEG
  harsh  ///< noise σ 6, blur up to 2.5 px, light 0.4…1.3, glare, worn paint (25 %), gaps, clutter, JPEG
};
inline constexpr FrameLevel kFrameLevels[] = {FrameLevel::clean, FrameLevel::real_like, FrameLevel::harsh};
std::string name_of(FrameLevel level);

/// A picture of a painted floor and what is true of it.
struct LineFrame {
  cv::Mat bgr;
  features::CameraPose camera;               ///< as told: above clean, roll and pitch are off by σ 0.2°
  std::optional<features::ImageLine> truth;  ///< the centreline, tilt and perspective included; none: no line
};

inline constexpr double kEmptyShare = 0.1;

/// Frame `index` of a series: random position, yaw, tilt ±10°, height 0.4…1.2 m, line width 0.05…0.4 m. One
/// in five runs nearly across the image, a share of `empty` (0…1) shows no line, and of the others one in
/// four at the levels above clean shows a side branch. The same arguments give the same frame.
LineFrame make_line_frame(cv::Size size, FrameLevel level, std::uint64_t seed, int index,
                          double empty = kEmptyShare);

}  // namespace lineservo::apps
