#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "apps/output/result_folder.h"
#include "apps/video/video_sink.h"

namespace lineservo::apps {

/// What is tried, one after the other: H.264, MPEG-4, Motion JPEG.
const std::vector<VideoCodec>& video_codecs();

/// A video among the results of a folder, in real time: a picture is shown until the next one's time.
class VideoFile {
 public:
  /// Begins STEM.mp4, or with another ending if the first codec that can be had wants it; the libraries are
  /// loaded by the first. `owner` as in ResultFolder::reserve(). Throws InputError when no codec can be had.
  VideoFile(ResultFolder& folder, const std::string& stem, const std::string& owner, double rate_hz,
            cv::Size size, const std::vector<VideoCodec>& codecs = video_codecs());

  /// The file's name.
  const std::string& name() const { return name_; }
  /// A line that says which codec it is and why; empty with the first.
  const std::string& note() const { return note_; }
  /// Times must grow; the first one is the video's begin. What comes within the time of an earlier picture is
  /// left out.
  void add(double time_s, const cv::Mat& picture);
  /// Ends the file; publishing is the folder's. Without a picture there is none. Throws InputError when it
  /// could not be written whole.
  void finish();

 private:
  void write(const cv::Mat& picture);

  ResultFolder& folder_;
  double rate_hz_;
  std::string name_, note_;
  std::unique_ptr<VideoSink> sink_;
  cv::Mat last_;
  double begin_s_ = 0.0;
  long frames_ = 0;
};

/// Earlier videos of this stem in the folder go when it is published, where `owner`, a file of the earlier
/// set, stands beside them; but not the one named `kept`.
void leave_out_videos(ResultFolder& folder, const std::string& stem, const std::string& owner,
                      const std::string& kept = {});

}  // namespace lineservo::apps
