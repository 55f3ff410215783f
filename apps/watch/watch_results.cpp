#include "apps/watch/watch_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "apps/calibrate/camera_text.h"
#include "apps/config/input_error.h"
#include "apps/output/result_kind.h"
#include "apps/watch/watch_table.h"

namespace lineservo::apps {
namespace {

constexpr const char* kTable = "watch.csv";
constexpr const char* kConfig = "config.yaml";

namespace fs = std::filesystem;

const std::vector<std::string> kRecordFiles = {kRecordingInfo, kRecordingTable, kRecordingCamera, kConfig,
                                               kTable};

/// A table of watch may be replaced and an empty file: anything else may be what is being watched.
void keep_what_is_no_table(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error) || fs::file_size(file, error) == 0) return;
  std::string header = watch_header({});
  header.pop_back();  // the controllers' columns follow
  std::string begin(header.size(), '\0');
  std::ifstream(file, std::ios::binary).read(begin.data(), static_cast<std::streamsize>(begin.size()));
  if (begin != header)
    throw InputError(fmt::format(
        "watch: --out {}: is there already and no table of watch; allowed: a new file, or such a table",
        file.string()));
}

bool is_same(const fs::path& a, const fs::path& b) {
  std::error_code error;
  return fs::equivalent(a, b, error);
}

/// Whether a recording into the folder would write over the file, folder or sequence of files.
bool is_replaced(const fs::path& input, const fs::path& folder) {
  const fs::path frames = folder / kRecordingFrames;
  if (is_same(input, folder) || is_same(input, frames) || is_same(input.parent_path(), frames)) return true;
  return std::ranges::any_of(kRecordFiles,
                             [&](const std::string& name) { return is_same(input, folder / name); });
}

void keep_what_is_read(const WatchRequest& request, const std::string& folder) {
  const std::string nothing;
  for (const std::string& input : {request.source, request.camera.value_or(nothing),
                                   request.height.value_or(nothing), request.conditions.value_or(nothing)})
    if (is_replaced(input, folder))
      throw InputError(fmt::format("watch: --record {}: would replace {}, which is read", folder, input));
}

}  // namespace

WatchResults::WatchResults(const std::optional<std::string>& out, const std::optional<std::string>& record,
                           const WatchRequest& request, const OpenWatch& opened)
    : table_(watch_header(opened.controllers)) {
  if (out) {
    const fs::path file = *out;
    keep_what_is_no_table(file);
    out_name_ = file.filename().string();
    out_.emplace(file.has_parent_path() ? file.parent_path() : ".", std::vector{out_name_});
  }
  if (record) begin_recording(*record, request, opened);
}

void WatchResults::begin_recording(const std::string& folder, const WatchRequest& request,
                                   const OpenWatch& opened) {
  keep_what_is_read(request, folder);
  refuse_other_kinds(folder, ResultKind::recording, "watch: --record");
  record_.emplace(folder, kRecordFiles, "--record");
  RecordingInfo info;
  info.kind = RecordingKind::watch;
  info.source = request.source;
  info.controllers = opened.controllers;
  recorder_.emplace(*record_, std::move(info));
  config_ = config_text(opened.request);
  camera_ = ros_text(opened.feed->camera());
}

std::string WatchResults::add(const Watched& watched) {
  const cv::Mat& bgr = watched.tick.bgr;
  if (recorder_) recorder_->add(watched.tick.input, bgr.empty() ? nullptr : &bgr, watched.outputs);
  std::string row = watch_row(watched);
  if (out_ || record_) table_ += row;
  return row;
}

void WatchResults::publish() {
  if (out_) {
    out_->write(out_name_, table_);
    out_->publish();
  }
  if (!record_) return;
  recorder_->write();
  record_->write(kRecordingCamera, camera_);
  record_->write(kConfig, config_);
  record_->write(kTable, table_);
  record_->publish();
}

}  // namespace lineservo::apps
