#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <deque>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <vector>

#include "features/geometry/camera_model.h"
#include "vehicle/floor/floor_renderer.h"
#include "vehicle/floor/frame.h"
#include "vehicle/floor/frame_link.h"
#include "vehicle/floor/image_noise.h"
#include "vehicle/floor/layout.h"
#include "vehicle/floor/motion_track.h"
#include "vehicle/time.h"

namespace lineservo::vehicle {

/// The simulated camera, and what stands between the floor and its frames.
struct SyntheticCameraOptions {
  features::CameraParameters camera;
  double frame_rate_hz = 30.0;  ///< 0.1 … 1000
  FloorLook look;
  ShutterOptions shutter;
  FrameLinkOptions link;     ///< latency, jitter, lost frames
  double noise_sigma = 0.0;  ///< of full scale, 0 … 0.1
  /// How far the camera is mounted off down_camera_R_BC(): angles about x_B and y_B, up to 0.2 in all.
  Eigen::Vector2d mount_tilt_rad = Eigen::Vector2d::Zero();
};

/// The down-looking camera at the body origin, mounted as down_camera_R_BC() but for its tilt, over a painted
/// floor. Frame k is exposed at k / rate, in the middle, and delivered a latency later, if it is not lost.
class SyntheticCamera {
 public:
  /// Throws std::invalid_argument that names what is out of bounds in the options or unsound in the layout.
  SyntheticCamera(const Layout& layout, const SyntheticCameraOptions& options, std::uint64_t seed);

  /// The instant of the next exposure: k / rate rounded to the nanosecond, without drift.
  Time next_exposure() const;
  /// The next exposure is now or past.
  bool due(Time now) const { return now >= next_exposure(); }
  /// The shutter takes its time: move() is to be called wherever the body is.
  bool follows_motion() const { return !shutter_.is_instant(); }
  /// Notes where the body is. Times must grow.
  void move(Time now, const Eigen::Isometry3d& X_WB);
  /// Takes the frame that is due, with the body's pose now at mid-exposure, stamps it now and queues it.
  /// Exposures missed since are skipped. Requires due(now).
  void capture(Time now, const Eigen::Isometry3d& X_WB);
  /// A frame's exposure is over, and it has not been drawn yet.
  bool has_exposed(Time now) const;
  /// Draws it.
  void develop();
  /// When the oldest frame under way becomes available; the end of time when there is none.
  Time next_delivery() const;
  /// The oldest frame that has become available, or none. Frames come in order.
  std::optional<Frame> deliver(Time now);

 private:
  struct Underway {
    Frame frame;
    Time arrival;
    Time exposed;  ///< the last row's closing
    Eigen::Isometry3d X_WB;
    bool is_drawn = false;
  };

  void draw(Underway& underway);
  cv::Mat free_buffer();

  double frame_rate_hz_;
  FrameLink link_;
  features::CameraModel camera_;
  Eigen::Isometry3d X_BC_;
  std::unique_ptr<FloorRenderer> renderer_;  ///< the warp refers to it
  ShutterOptions shutter_;
  Time half_window_;
  std::unique_ptr<ShutterWarp> warp_;  ///< none when the shutter takes no time
  MotionTrack track_;
  ImageNoise noise_;
  std::int64_t next_index_ = 0;
  std::deque<Underway> queue_;
  std::vector<cv::Mat> buffers_;
};

}  // namespace lineservo::vehicle
