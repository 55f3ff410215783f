#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "apps/onboard/tick_input.h"
#include "apps/output/command_row.h"

namespace lineservo::apps {

/// What one controller made of a tick.
struct RecordedOutput {
  CommandRow command{};
  std::string command_sha256, features_sha256;
};

/// A row of recording.csv.
struct RecordedTick {
  TickInput input;
  std::string estimates_sha256;         ///< of the input
  std::string frame;                    ///< its file in frames/; empty when the tick had none
  std::string frame_sha256;             ///< of the file, byte for byte
  std::vector<RecordedOutput> outputs;  ///< one for each controller
};

std::string recording_header(const std::vector<std::string>& controllers);
/// Numbers read back to the last bit.
std::string recording_row(const RecordedTick& tick);

/// Reads recording.csv. Throws InputError, with the line, for what is none of these controllers.
std::vector<RecordedTick> read_recording_table(const std::filesystem::path& file,
                                               const std::vector<std::string>& controllers);

}  // namespace lineservo::apps
