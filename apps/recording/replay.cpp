#include "apps/recording/replay.h"

#include <fmt/format.h>

#include "apps/config/input_error.h"
#include "apps/config/text_file.h"
#include "apps/output/sha256.h"
#include "apps/recording/digest.h"

namespace lineservo::apps {
namespace {

namespace fs = std::filesystem;
using Difference = std::optional<std::string>;
using Chains = std::vector<std::unique_ptr<Chain>>;

Chains make_chains(const Recording& recording, const std::vector<std::string>& controllers) {
  Chains chains;
  for (const std::string& controller : controllers) chains.push_back(make_chain(recording, controller));
  return chains;
}

std::string place(std::size_t row, const RecordedTick& tick) {
  return fmt::format("tick {} at {:.3f} s", row, servo::seconds(tick.input.now));
}

Difference changed_frame(const fs::path& folder, const RecordedTick& tick) {
  if (tick.input.has_frame == tick.frame.empty()) return "whether it has a frame is not as it was recorded";
  if (tick.frame.empty()) return std::nullopt;
  const fs::path file = fs::path(kRecordingFrames) / tick.frame;
  std::error_code error;
  if (!fs::is_regular_file(folder / file, error)) return fmt::format("frame {} is missing", file.string());
  if (sha256_hex(read_bytes(folder / file)) == tick.frame_sha256) return std::nullopt;
  return fmt::format("frame {} is not the one that was recorded", file.string());
}

/// What was changed in a row or its frame since it was recorded.
Difference changed(const Recording& recording, const RecordedTick& tick) {
  if (digest(tick.input) != tick.estimates_sha256) return "the estimates are not those that were recorded";
  if (auto frame = changed_frame(recording.folder, tick)) return frame;
  for (std::size_t k = 0; k < tick.outputs.size(); ++k)
    if (digest(tick.outputs[k].command) != tick.outputs[k].command_sha256)
      return fmt::format("the command of {} is not the one that was recorded", recording.info.controllers[k]);
  return std::nullopt;
}

/// Features and command; without a frame the features are empty.
struct Outcome {
  std::string features_sha256;
  servo::Command command;
};

Outcome run(Chain& chain, const TickInput& input, const std::optional<cv::Mat>& frame) {
  features::FrameFeatures features;
  if (frame) features = chain.see(input, *frame);
  const servo::Command command = chain.command(input, std::move(features));
  return {digest(chain.observation().features), command};
}

Difference compared(const Outcome& outcome, const RecordedOutput& recorded, const std::string& controller) {
  if (outcome.features_sha256 != recorded.features_sha256)
    return fmt::format("{} sees other features than were recorded", controller);
  if (digest(row_of(outcome.command)) != recorded.command_sha256)
    return fmt::format("{} gives another command than was recorded", controller);
  return std::nullopt;
}

/// Rows that were added or left out, and what no row's hash covers.
Difference changed_table(const Recording& recording) {
  const RecordingInfo& info = recording.info;
  if (recording.ticks.size() != info.ticks)
    return fmt::format("{} has {} ticks, {} were recorded", kRecordingTable, recording.ticks.size(),
                       info.ticks);
  if (sha256_hex(read_bytes(recording.folder / kRecordingTable)) != info.table_sha256)
    return fmt::format("{} is not the one that was recorded", kRecordingTable);
  return std::nullopt;
}

class Replay {
 public:
  Replay(const Recording& recording, const ReplayOptions& options)
      : recording_(recording),
        options_(options),
        chains_(make_chains(recording, recording.info.controllers)),
        others_(make_chains(recording, options.others)),
        commands_(options.others.size()) {}

  Difference run_tick(const RecordedTick& tick) {
    if (auto difference = changed(recording_, tick)) return difference;
    const std::optional<cv::Mat> frame = read_frame(recording_, tick);
    for (std::size_t k = 0; k < chains_.size(); ++k) {
      const Outcome outcome = run(*chains_[k], tick.input, frame);
      if (auto difference = compared(outcome, tick.outputs[k], recording_.info.controllers[k]))
        return difference;
    }
    for (std::size_t k = 0; k < others_.size(); ++k)
      commands_[k] = run(*others_[k], tick.input, frame).command;
    return std::nullopt;
  }
  bool goes_on(const RecordedTick& tick) const {
    return !options_.on_tick || options_.on_tick({tick, commands_});
  }

 private:
  const Recording& recording_;
  const ReplayOptions& options_;
  Chains chains_, others_;
  std::vector<servo::Command> commands_;
};

}  // namespace

std::optional<std::string> replay(const Recording& recording, const ReplayOptions& options) {
  Replay replay(recording, options);
  for (std::size_t row = 0; row < recording.ticks.size(); ++row) {
    const RecordedTick& tick = recording.ticks[row];
    if (auto difference = replay.run_tick(tick)) return place(row, tick) + ": " + *difference;
    if (!replay.goes_on(tick)) return std::nullopt;
  }
  return changed_table(recording);
}

}  // namespace lineservo::apps
