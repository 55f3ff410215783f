#pragma once

#include <opencv2/core/mat.hpp>
#include <string>

namespace lineservo::apps {

/// How a video is coded, and the file's ending that goes with it.
struct VideoCodec {
  std::string name;    ///< for people
  std::string fourcc;  ///< four letters, as OpenCV has them
  std::string ending;
};

struct VideoSpec {
  std::string path;
  VideoCodec codec;
  double rate_hz = 30.0;
  cv::Size size;  ///< even sides
};

/// A video file that is being written.
class VideoSink {
 public:
  VideoSink() = default;
  virtual ~VideoSink() = default;
  VideoSink(const VideoSink&) = delete;
  VideoSink& operator=(const VideoSink&) = delete;

  /// CV_8UC3 of the spec's size.
  virtual void write(const cv::Mat& bgr) = 0;
  /// Ends the file; false when not all of it can be read back: the libraries do not tell of a full disk.
  virtual bool finish() = 0;
};

}  // namespace lineservo::apps
