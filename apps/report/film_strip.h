#pragma once

#include <cstddef>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "apps/flight/flight.h"

namespace lineservo::apps {

/// A small picture of what the camera saw, for the slider of a report.
struct Thumbnail {
  double t_s = 0.0;      ///< of the control tick that looked at the frame
  std::string data_uri;  ///< data:image/jpeg;base64,…
};

/// Keeps small pictures of the frames of a flight, evenly over it however long it gets: when there are too
/// many every other one goes, and from then on they are taken half as often.
class FilmStrip {
 public:
  static constexpr std::size_t kMost = 300;
  static constexpr int kWidth_px = 200;  ///< of frames that are not smaller

  /// Frames are CV_8UC3 (BGR), their times ascend.
  void add(servo::Time now, const cv::Mat& bgr);
  /// The frame of a tick, if it has one.
  void add(const FlightTick& tick);
  /// Encodes what is kept; as for threads as read_image().
  std::vector<Thumbnail> thumbnails() const;

 private:
  struct Picture {
    servo::Time t;
    cv::Mat bgr;
  };
  void thin_out();

  servo::Time period_ = std::chrono::milliseconds(500), next_{0};
  std::vector<Picture> pictures_;
};

}  // namespace lineservo::apps
