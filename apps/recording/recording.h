#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "apps/config/flight_request.h"
#include "apps/onboard/chain.h"
#include "apps/recording/recording_info.h"
#include "apps/recording/recording_table.h"

namespace lineservo::apps {

/// A recording of fly or watch, but for its frames.
struct Recording {
  std::filesystem::path folder;
  RecordingInfo info;
  FlightRequest request;
  features::CameraParameters camera;
  std::vector<RecordedTick> ticks;
};

/// The folder holds a recording, whole or not.
bool is_recording(const std::filesystem::path& folder);

/// Throws InputError when the folder holds none, or one that cannot be read; also for one of another version
/// of the program. What was changed in it is for replay() to find.
Recording read_recording(const std::filesystem::path& folder);

/// The chain that made the recording's commands, with this controller, as it was before the first tick.
/// Throws InputError or std::invalid_argument.
std::unique_ptr<Chain> make_chain(const Recording& recording, const std::string& controller);

/// A tick's frame. None when the tick has none. Throws InputError when it cannot be read or is not of the
/// camera's size.
std::optional<cv::Mat> read_frame(const Recording& recording, const RecordedTick& tick);

}  // namespace lineservo::apps
