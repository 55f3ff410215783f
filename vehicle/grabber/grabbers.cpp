#include "vehicle/grabber/grabbers.h"

#include <opencv2/core/utils/logger.hpp>

#include "vehicle/grabber/source_name.h"
#include "vehicle/grabber/sources.h"
#include "vehicle/grabber/steady_source.h"

namespace lineservo::vehicle {
namespace {

std::unique_ptr<FrameSource> opened(const std::string& name, const GrabberOptions& options) {
  switch (source_kind(name)) {
    case SourceKind::folder:
      return open_folder(name, options);
    case SourceKind::sequence:
      return open_sequence(name, options);
    case SourceKind::device:
      return open_device(device_path(name), options);
    case SourceKind::stream:
      return open_stream(name);
    case SourceKind::pipeline:
      return open_pipeline(name);
    case SourceKind::video:
      break;
  }
  return open_video(name, options);
}

}  // namespace

std::unique_ptr<FrameSource> open_source(const std::string& name, const GrabberOptions& options) {
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);  // what fails is told in one line
  return std::make_unique<SteadySource>(opened(name, options), name);
}

Time monotonic_now() {
  return std::chrono::steady_clock::now().time_since_epoch();
}

}  // namespace lineservo::vehicle
