#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace lineservo::apps {

/// Which chain made the commands.
enum class RecordingKind {
  flight,  ///< MissionChain, which carries out a plan
  watch,   ///< FollowChain, one for each controller
};

/// What recording.json says of a recording.
struct RecordingInfo {
  RecordingKind kind = RecordingKind::flight;
  std::string source;  ///< what was flown or watched
  std::vector<std::string> controllers;
  std::size_t ticks = 0, frames = 0;
  std::string table_sha256;  ///< of recording.csv, byte for byte
};

/// The files of a recording in its folder; what else it needs is the config.yaml there.
inline constexpr const char *kRecordingInfo = "recording.json", *kRecordingTable = "recording.csv",
                            *kRecordingCamera = "camera.yaml", *kRecordingFrames = "frames",
                            *kFrameEnding = ".png";

}  // namespace lineservo::apps
