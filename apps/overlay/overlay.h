#pragma once

#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

#include "apps/overlay/floor_map.h"
#include "apps/overlay/overlay_scene.h"
#include "features/geometry/camera_model.h"

namespace lineservo::apps {

struct OverlayOptions {
  std::string title;
  std::string law = {};                 ///< whose command it is
  double speed_m_s = 0.1;               ///< that of a full command arrow
  std::vector<std::string> notes = {};  ///< at the foot of the panel
};

/// Draws what the vehicle sees and does: the camera's frame with the features and the command on it and,
/// beside it, a panel with the map, the phase, the codes seen and expected, and the command in numbers.
/// Frames narrower than 640 px are enlarged by a whole factor, to 1080 px of height at most.
class Overlay {
 public:
  /// `map`: the floor and the plan, where they are known. Throws std::invalid_argument for a camera that is
  /// none.
  Overlay(const features::CameraParameters& camera, OverlayOptions options);
  Overlay(const features::CameraParameters& camera, OverlayOptions options, const vehicle::Layout& floor,
          const servo::Plan& plan);

  /// Of every picture; both sides are even.
  cv::Size size() const { return picture_.size(); }
  /// How many times as large as the frame the camera's part is, which lies at the top left.
  int zoom() const { return zoom_; }
  const std::optional<FloorMap>& map() const { return map_; }
  /// Where the map lies in the picture.
  cv::Rect map_place() const;

  /// CV_8UC3, BGR. Valid until the next call. A tick without a frame shows the last one, darkened.
  const cv::Mat& draw(const OverlayScene& scene);

 private:
  void draw_camera(const OverlayScene& scene);
  void draw_panel(const OverlayScene& scene);
  void draw_codes(Canvas& panel, const OverlayScene& scene, double top) const;
  void draw_notes(Canvas& panel) const;
  double panel_width() const;

  features::CameraModel camera_;
  OverlayOptions options_;
  int zoom_;
  double scale_;
  cv::Mat picture_;
  cv::Rect frame_place_, panel_place_;
  std::optional<FloorMap> map_;
  cv::Mat last_frame_;
};

}  // namespace lineservo::apps
