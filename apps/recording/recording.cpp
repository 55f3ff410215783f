#include "apps/recording/recording.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "apps/config/camera/camera_file.h"
#include "apps/config/input_error.h"
#include "apps/config/text_file.h"
#include "apps/flight/convert.h"
#include "apps/flight/mission.h"
#include "apps/image/image_file.h"
#include "apps/onboard/follow_chain.h"
#include "apps/onboard/mission_chain.h"

namespace lineservo::apps {
namespace {

namespace fs = std::filesystem;

RecordingKind kind_of(const std::string& word) {
  if (word == "flight") return RecordingKind::flight;
  if (word == "watch") return RecordingKind::watch;
  throw InputError("kind '" + word + "' must be flight or watch");
}

RecordingInfo read_info(const fs::path& file) try {
  const auto json = nlohmann::json::parse(read_text_file(file));
  check_version(json.at("version"), file.string());
  RecordingInfo info;
  info.kind = kind_of(json.at("kind"));
  info.source = json.at("source");
  info.controllers = json.at("controllers").get<std::vector<std::string>>();
  info.ticks = json.at("ticks");
  info.frames = json.at("frames");
  info.table_sha256 = json.at("table_sha256");
  return info;
} catch (const nlohmann::json::exception& fault) {
  throw InputError(fmt::format("{}: is not what a recording has: {}", file.string(), fault.what()));
}

}  // namespace

bool is_recording(const fs::path& folder) {
  std::error_code error;
  return fs::is_regular_file(folder / kRecordingInfo, error);
}

Recording read_recording(const fs::path& folder) {
  if (!is_recording(folder))
    throw InputError(
        fmt::format("{}: is not the folder of a recording: it has no {} (fly --record --out DIR and watch "
                    "--record DIR make one)",
                    folder.string(), kRecordingInfo));
  Recording recording;
  recording.folder = folder;
  recording.info = read_info(folder / kRecordingInfo);
  recording.request = read_config(folder / "config.yaml");
  recording.camera = recording.info.kind == RecordingKind::watch
                         ? read_camera(folder / kRecordingCamera)
                         : camera_parameters(recording.request.settings.camera);
  recording.ticks = read_recording_table(folder / kRecordingTable, recording.info.controllers);
  return recording;
}

std::unique_ptr<Chain> make_chain(const Recording& recording, const std::string& controller) {
  FlightRequest request = recording.request;
  request.controller = controller;
  if (recording.info.kind == RecordingKind::watch)
    return std::make_unique<FollowChain>(recording.camera, request.settings,
                                         servo::find_controller(controller));
  const Mission mission = prepare(request);
  return std::make_unique<MissionChain>(mission.request, mission.plan);
}

std::optional<cv::Mat> read_frame(const Recording& recording, const RecordedTick& tick) {
  if (!tick.input.has_frame) return std::nullopt;
  const fs::path file = recording.folder / kRecordingFrames / tick.frame;
  cv::Mat frame = read_image(file);
  const features::CameraParameters& camera = recording.camera;
  if (frame.type() != CV_8UC3 || frame.cols != camera.width_px || frame.rows != camera.height_px)
    throw InputError(fmt::format("{}: is not a colour image of {}×{} px as the camera's", file.string(),
                                 camera.width_px, camera.height_px));
  return frame;
}

}  // namespace lineservo::apps
