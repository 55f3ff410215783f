#include "apps/video/video_file.h"

#include <fmt/format.h>

#include <cmath>
#include <set>

#include "apps/config/input_error.h"
#include "apps/module/module_function.h"

namespace lineservo::apps {
namespace {

using Open = VideoSink* (*)(const VideoSpec* spec);

std::unique_ptr<VideoSink> open(const VideoSpec& spec) {
  static const Open open_video =
      module_function<Open>("liblineservo_video_module.so", "lineservo_open_video", "video writers");
  return std::unique_ptr<VideoSink>(open_video(&spec));
}

}  // namespace

const std::vector<VideoCodec>& video_codecs() {
  static const std::vector<VideoCodec> kCodecs = {
      {"H.264", "avc1", ".mp4"}, {"MPEG-4", "mp4v", ".mp4"}, {"Motion JPEG", "MJPG", ".avi"}};
  return kCodecs;
}

VideoFile::VideoFile(ResultFolder& folder, const std::string& stem, const std::string& owner, double rate_hz,
                     cv::Size size, const std::vector<VideoCodec>& codecs)
    : folder_(folder), rate_hz_(rate_hz) {
  for (const VideoCodec& codec : codecs) {
    name_ = stem + codec.ending;
    sink_ = open({folder_.reserve(name_, owner).string(), codec, rate_hz, size});
    if (sink_) {
      if (&codec != &codecs.front())
        note_ = fmt::format("{} is {}: the installed codecs do not write {}", name_, codec.name,
                            codecs.front().name);
      return;
    }
    folder_.give_up(name_);
  }
  throw InputError(fmt::format("{}{}: cannot be written: no codec is installed for {}×{} px at {:g} frames/s",
                               stem, codecs.front().ending, size.width, size.height, rate_hz));
}

void VideoFile::add(double time_s, const cv::Mat& picture) {
  if (frames_ == 0) begin_s_ = time_s;
  const long place = std::lround((time_s - begin_s_) * rate_hz_);
  while (frames_ > 0 && frames_ < place) write(last_);
  if (frames_ == place) write(picture);
  picture.copyTo(last_);
}

void VideoFile::write(const cv::Mat& picture) {
  sink_->write(picture);
  ++frames_;
}

void VideoFile::finish() {
  const bool is_whole = sink_->finish();
  sink_.reset();
  if (frames_ == 0) return folder_.give_up(name_);
  if (!is_whole)
    throw InputError((folder_.path() / name_).string() + ": cannot be written whole; is the disk full?");
}

void leave_out_videos(ResultFolder& folder, const std::string& stem, const std::string& owner,
                      const std::string& kept) {
  std::set<std::string> names;
  for (const VideoCodec& codec : video_codecs()) names.insert(stem + codec.ending);
  names.erase(kept);
  for (const std::string& name : names) folder.leave_out(name, owner);
}

}  // namespace lineservo::apps
