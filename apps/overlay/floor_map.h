#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <vector>

#include "apps/overlay/canvas.h"
#include "apps/overlay/overlay_scene.h"
#include "servo/plan/plan.h"
#include "vehicle/floor/layout.h"

namespace lineservo::apps {

/// A small map of a flight: the floor's paint, the way of the plan (thin black line), its targets (rings),
/// the path flown so far (blue) and the vehicle. +x is to the right, +y up.
class FloorMap {
 public:
  /// As large as the floor's shape lets it be within `most` pixels.
  FloorMap(const vehicle::Layout& floor, const servo::Plan& plan, cv::Size most, double scale);

  cv::Size size() const { return ground_.size(); }
  /// Where a point of the floor lies in it, in pixels.
  cv::Point2d at(const Eigen::Vector2d& p_W) const;
  /// Draws it into `part` of a picture, which has its size, and remembers the place as flown over.
  void draw(cv::Mat part, const MapPose& vehicle);

 private:
  void fit(const vehicle::Layout& floor, cv::Size most, double scale);
  void paint(const vehicle::Layout& floor);
  void paint(const vehicle::FloorBitmap& bitmap, const cv::Scalar& around);
  std::vector<cv::Point2d> places(const vehicle::Curve& curve) const;
  void mark(const vehicle::Layout& floor, const servo::Plan& plan);

  cv::Mat ground_;  ///< with the path flown so far
  double scale_;
  double pixels_per_metre_ = 1.0;
  Eigen::Vector2d top_left_W_ = Eigen::Vector2d::Zero();
  std::optional<cv::Point2d> last_;
};

}  // namespace lineservo::apps
