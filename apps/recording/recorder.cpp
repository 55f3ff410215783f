#include "apps/recording/recorder.h"

#include <nlohmann/json.hpp>

#include "apps/image/image_file.h"
#include "apps/output/json_text.h"
#include "apps/output/sha256.h"
#include "apps/recording/digest.h"
#include "apps/version.h"

namespace lineservo::apps {
namespace {

std::string text_of(const RecordingInfo& info) {
  return json_text({{"version", kVersion},
                    {"kind", info.kind == RecordingKind::flight ? "flight" : "watch"},
                    {"source", info.source},
                    {"controllers", info.controllers},
                    {"ticks", info.ticks},
                    {"frames", info.frames},
                    {"table_sha256", info.table_sha256}},
                   2);
}

RecordedOutput recorded(const ChainOutput& output) {
  const CommandRow row = row_of(output.command);
  return {row, digest(row), digest(output.features)};
}

}  // namespace

Recorder::Recorder(ResultFolder& folder, RecordingInfo info) : folder_(folder), info_(std::move(info)) {
  folder_.begin_folder(kRecordingFrames, kFrameEnding, kRecordingInfo);
  table_ = recording_header(info_.controllers);
}

void Recorder::add(const TickInput& input, const cv::Mat* bgr, std::span<const ChainOutput> outputs) {
  RecordedTick tick;
  tick.input = input;
  tick.estimates_sha256 = digest(input);
  if (bgr) keep_frame(*bgr, tick);
  for (const ChainOutput& output : outputs) tick.outputs.push_back(recorded(output));
  table_ += recording_row(tick);
  ++info_.ticks;
}

void Recorder::keep_frame(const cv::Mat& bgr, RecordedTick& tick) {
  const std::string png = png_bytes(bgr);
  tick.frame = numbered(info_.frames, kFrameEnding);
  tick.frame_sha256 = sha256_hex(png);
  folder_.write_numbered(info_.frames++, png);
}

void Recorder::write() {
  info_.table_sha256 = sha256_hex(table_);
  folder_.write(kRecordingInfo, text_of(info_));
  folder_.write(kRecordingTable, table_);
}

void leave_out_recording(ResultFolder& folder) {
  folder.leave_out_folder(kRecordingFrames, kFrameEnding, kRecordingInfo);
  for (const char* name : {kRecordingTable, kRecordingInfo}) folder.leave_out(name);
}

}  // namespace lineservo::apps
