#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "features/junction/junction_code.h"
#include "features/perception.h"
#include "vehicle/floor/layout.h"
#include "vehicle/floor/wear_options.h"

namespace lineservo::apps {

/// How the camera is carried along the routes: jitter is first-order Gauss–Markov with a time constant of 0.5
/// s.
struct JunctionStudyOptions {
  std::vector<std::string> instructions = {"a03", "a13", "a23", "a53"};
  double step_m = 0.01;  ///< between two frames: 0.1 m/s at 10 frames/s
  double height_m = 0.5;
  double yaw_sigma_deg = 0.0;
  double tilt_sigma_deg = 0.0;
  double offset_sigma_m = 0.02;     ///< across the line
  double attitude_error_deg = 0.0;  ///< standard deviation of what perception is told, per axis
  double noise_levels = 2.0;        ///< of 255
  double blur_px = 0.0;             ///< standard deviation of a Gaussian
  vehicle::WearOptions wear = {};
  std::uint64_t seed = 1;
};

inline constexpr std::array<int, 4> kWindows = {1, 3, 5, 9};

/// What one recogniser made of all frames.
struct RecogniserScore {
  std::string method;
  long frames = 0;
  long ambiguous = 0;
  long raw_wrong = 0;
  std::array<long, kWindows.size()> smoothed_wrong = {};  ///< by window
  std::array<int, kWindows.size()> events_right = {};     ///< nodes told with the right code, by window
  int events = 0;                                         ///< nodes passed
  int events_false = 0;                                   ///< told with window 5 where the way has none
  std::array<std::array<long, features::kJunctionCodes>, features::kJunctionCodes> confusion =
      {};                      ///< [true][raw]
  double perception_ms = 0.0;  ///< mean a frame
};

/// Flies a perfect camera along the routes of a layout and scores both recognisers on the same frames by the
/// true pose. Frames of the straight stretches count; at a turn the camera jumps to the next leg. Throws
/// InputError for an instruction that the layout does not have.
std::vector<RecogniserScore> study_junctions(const vehicle::Layout& layout,
                                             const JunctionStudyOptions& options);

}  // namespace lineservo::apps
