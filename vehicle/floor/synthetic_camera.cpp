#include "vehicle/floor/synthetic_camera.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <opencv2/core.hpp>
#include <stdexcept>

#include "features/geometry/level_view.h"

namespace lineservo::vehicle {
namespace {

SyntheticCameraOptions valid(const SyntheticCameraOptions& options) {
  if (!(options.frame_rate_hz >= 0.1 && options.frame_rate_hz <= 1000.0))
    throw std::invalid_argument("camera: the frame rate must be 0.1 to 1000 Hz");
  if (!(options.mount_tilt_rad.norm() <= 0.2))
    throw std::invalid_argument("camera: the mount's tilt must be up to 0.2 rad");
  options.shutter.validate();
  return options;
}

Time exposure(std::int64_t index, double frame_rate_hz) {
  return Time(std::llround(static_cast<double>(index) * 1e9 / frame_rate_hz));
}

// Turned by the vector (x, y, 0) in B.
Eigen::Isometry3d mounted_X_BC(const Eigen::Vector2d& tilt_rad) {
  Eigen::Isometry3d X_BC = Eigen::Isometry3d::Identity();
  X_BC.linear() = features::down_camera_R_BC();
  const double angle_rad = tilt_rad.norm();
  if (angle_rad == 0.0) return X_BC;
  const Eigen::Vector3d axis_B(tilt_rad.x() / angle_rad, tilt_rad.y() / angle_rad, 0.0);
  X_BC.linear() = Eigen::AngleAxisd(angle_rad, axis_B).toRotationMatrix() * features::down_camera_R_BC();
  return X_BC;
}

}  // namespace

SyntheticCamera::SyntheticCamera(const Layout& layout, const SyntheticCameraOptions& options,
                                 std::uint64_t seed)
    : frame_rate_hz_(valid(options).frame_rate_hz),
      link_(options.link, seed),
      camera_(options.camera),
      X_BC_(mounted_X_BC(options.mount_tilt_rad)),
      renderer_(std::make_unique<FloorRenderer>(layout, camera_, options.look, seed)),
      shutter_(options.shutter),
      half_window_(from_seconds(shutter_.half_window_s())),
      warp_(shutter_.is_instant() ? nullptr : std::make_unique<ShutterWarp>(renderer_->grid(), shutter_)),
      noise_(options.noise_sigma, seed) {}

Time SyntheticCamera::next_exposure() const {
  return exposure(next_index_, frame_rate_hz_);
}

void SyntheticCamera::capture(Time now, const Eigen::Isometry3d& X_WB) {
  assert(due(now));
  while (exposure(next_index_ + 1, frame_rate_hz_) <= now) ++next_index_;
  const std::int64_t index = next_index_++;
  if (link_.loses(index)) return;
  const Time exposed = now + half_window_;
  queue_.push_back({{now, index, {}}, link_.arrival(index, now, exposed), exposed, X_WB});
}

void SyntheticCamera::move(Time now, const Eigen::Isometry3d& X_WB) {
  const auto waiting =
      std::find_if(queue_.begin(), queue_.end(), [](const Underway& u) { return !u.is_drawn; });
  track_.forget_before(std::min(now, waiting == queue_.end() ? now : waiting->frame.stamp) - half_window_);
  track_.add(now, X_WB);
}

bool SyntheticCamera::has_exposed(Time now) const {
  return std::any_of(queue_.begin(), queue_.end(),
                     [now](const Underway& u) { return !u.is_drawn && u.exposed <= now; });
}

void SyntheticCamera::develop() {
  const auto waiting =
      std::find_if(queue_.begin(), queue_.end(), [](const Underway& u) { return !u.is_drawn; });
  if (waiting != queue_.end()) draw(*waiting);
}

void SyntheticCamera::draw(Underway& underway) {
  Frame& frame = underway.frame;
  frame.bgr = free_buffer();
  if (warp_) {
    const auto X_WC = [&](double delay_s) -> Eigen::Isometry3d {
      return track_.at(frame.stamp + from_seconds(delay_s)) * X_BC_;
    };
    renderer_->render(X_WC, *warp_, frame.bgr);
  } else {
    renderer_->render(underway.X_WB * X_BC_, frame.bgr);
  }
  noise_.add(frame.index, frame.bgr);
  underway.is_drawn = true;
}

Time SyntheticCamera::next_delivery() const {
  return queue_.empty() ? Time::max() : queue_.front().arrival;
}

std::optional<Frame> SyntheticCamera::deliver(Time now) {
  if (queue_.empty() || now < next_delivery()) return std::nullopt;
  if (!queue_.front().is_drawn) draw(queue_.front());
  std::optional<Frame> frame(std::move(queue_.front().frame));
  queue_.pop_front();
  return frame;
}

// A buffer that nobody but the pool refers to; a new one only while more are held than ever before.
cv::Mat SyntheticCamera::free_buffer() {
  for (const cv::Mat& buffer : buffers_)
    if (buffer.u->refcount == 1) return buffer;
  buffers_.emplace_back(camera_.height_px(), camera_.width_px(), CV_8UC3);
  return buffers_.back();
}

}  // namespace lineservo::vehicle
