#include "apps/watch/watch_results.h"

#include <filesystem>

#include "apps/calibrate/camera_text.h"
#include "apps/config/input_error.h"
#include "apps/watch/watch_table.h"

namespace lineservo::apps {
namespace {

constexpr const char* kTable = "watch.csv";
constexpr const char* kConfig = "config.yaml";

}  // namespace

WatchResults::WatchResults(const std::optional<std::string>& out, const std::optional<std::string>& record,
                           const std::string& source, const OpenWatch& opened)
    : table_(watch_header(opened.controllers)) {
  if (out) {
    const std::filesystem::path file = *out;
    out_name_ = file.filename().string();
    out_.emplace(file.has_parent_path() ? file.parent_path() : ".", std::vector{out_name_});
  }
  if (record) begin_recording(*record, source, opened);
}

void WatchResults::begin_recording(const std::string& folder, const std::string& source,
                                   const OpenWatch& opened) {
  std::error_code error;
  if (std::filesystem::equivalent(folder, source, error))
    throw InputError("watch: --record " + folder + ": is the source itself");
  record_.emplace(
      folder, std::vector<std::string>{kRecordingInfo, kRecordingTable, kRecordingCamera, kConfig, kTable});
  RecordingInfo info;
  info.kind = RecordingKind::watch;
  info.source = source;
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
