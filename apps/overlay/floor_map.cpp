#include "apps/overlay/floor_map.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "apps/overlay/ink.h"

namespace lineservo::apps {
namespace {

constexpr double kLeastSide_m = 0.5;  // of the shown floor
constexpr double kBorder = 0.06;      // of the longer side, about the paint
constexpr double kLeastLine_px = 2.5, kLeastDisc_px = 2.5;

cv::Scalar scalar(const vehicle::Bgr& colour) {
  return {double(colour[0]), double(colour[1]), double(colour[2])};
}

void draw_vehicle(Canvas& canvas, cv::Point2d at, double heading_rad) {
  const double c = canvas.scale() * std::cos(heading_rad), s = canvas.scale() * std::sin(heading_rad);
  const auto corner = [&](double forward, double left) {
    return at + cv::Point2d(forward * c - left * s, -forward * s - left * c);
  };
  canvas.polygon({corner(9.5, 0.0), corner(-6.0, 7.0), corner(-6.0, -7.0)}, ink::kWhite);
  canvas.polygon({corner(7.0, 0.0), corner(-4.5, 5.0), corner(-4.5, -5.0)}, ink::kVermilion);
}

Eigen::AlignedBox2d extent(const vehicle::Layout& floor) {
  Eigen::AlignedBox2d box;
  for (const vehicle::LayoutEdge& edge : floor.edges)
    for (const Eigen::Vector2d& p_W : edge.centreline.outline()) box.extend(p_W);
  const Eigen::Vector2d least = Eigen::Vector2d::Constant(0.5 * kLeastSide_m);
  box.extend(box.center() + least);
  box.extend(box.center() - least);
  const double border_m = kBorder * box.sizes().maxCoeff();
  box.min().array() -= border_m;
  box.max().array() += border_m;
  return box;
}

}  // namespace

FloorMap::FloorMap(const vehicle::Layout& floor, const servo::Plan& plan, cv::Size most, double scale)
    : scale_(scale) {
  fit(floor, most, scale);
  paint(floor);
  mark(floor, plan);
}

void FloorMap::fit(const vehicle::Layout& floor, cv::Size most, double scale) {
  const Eigen::AlignedBox2d box = extent(floor);
  const Eigen::Vector2d sides_m = box.sizes();
  pixels_per_metre_ = std::min(most.width / sides_m.x(), most.height / sides_m.y());
  const auto whole = [&](double side_m) {
    return std::max(static_cast<int>(24.0 * scale), static_cast<int>(std::floor(side_m * pixels_per_metre_)));
  };
  ground_.create(whole(sides_m.y()), whole(sides_m.x()), CV_8UC3);
  ground_.setTo(scalar(floor.floor_colour));
  const Eigen::Vector2d shown_m = Eigen::Vector2d(ground_.cols, ground_.rows) / pixels_per_metre_;
  top_left_W_ = box.center() + 0.5 * Eigen::Vector2d(-shown_m.x(), shown_m.y());
}

cv::Point2d FloorMap::at(const Eigen::Vector2d& p_W) const {
  const Eigen::Vector2d d_px = (p_W - top_left_W_) * pixels_per_metre_;
  return {d_px.x() - 0.5, -d_px.y() - 0.5};
}

void FloorMap::paint(const vehicle::Layout& floor) {
  Canvas canvas(ground_, 1.0);
  const auto width_px = [this](double width_m, double least_px) {
    return std::max(least_px * scale_, width_m * pixels_per_metre_);
  };
  if (floor.bitmap) {
    paint(*floor.bitmap, scalar(floor.floor_colour));
  } else {
    for (const vehicle::LayoutEdge& edge : floor.edges)
      canvas.polyline(places(edge.centreline), {scalar(edge.colour), width_px(edge.width_m, kLeastLine_px)});
  }
  for (const auto* markers : {&floor.start_markers, &floor.end_markers})
    for (const vehicle::LayoutMarker& marker : *markers)
      canvas.disc(at(marker.p_W), width_px(marker.radius_m, kLeastDisc_px), scalar(marker.colour));
}

// A pixel of level k has 2ᵏ of the image's along its side; the image's last row is at the origin.
void FloorMap::paint(const vehicle::FloorBitmap& bitmap, const cv::Scalar& around) {
  const int level = bitmap.level_for(1.0 / pixels_per_metre_);
  const double fine_m = bitmap.metres_per_pixel(), coarse_m = fine_m * (1 << level);
  const double half_m = 0.5 * (coarse_m - fine_m);
  const cv::Point2d first =
      at(bitmap.origin_W() + Eigen::Vector2d(half_m, (bitmap.image().rows - 1) * fine_m - half_m));
  const double zoom = coarse_m * pixels_per_metre_;
  const cv::Matx23d placed(zoom, 0.0, first.x, 0.0, zoom, first.y);
  cv::warpAffine(bitmap.level(level), ground_, placed, ground_.size(), cv::INTER_LINEAR, cv::BORDER_CONSTANT,
                 around);
}

std::vector<cv::Point2d> FloorMap::places(const vehicle::Curve& curve) const {
  std::vector<cv::Point2d> places;
  for (const Eigen::Vector2d& p_W : curve.outline()) places.push_back(at(p_W));
  return places;
}

void FloorMap::mark(const vehicle::Layout& floor, const servo::Plan& plan) {
  Canvas canvas(ground_, scale_);
  for (const servo::TopologyArm& arm : plan.route)
    canvas.polyline(places(floor.edges[arm.edge].centreline), {ink::kBlack, 1.0});
  for (const std::size_t step : servo::target_steps(plan))
    for (const vehicle::LayoutNode& node : floor.nodes)
      if (node.name == plan.steps[step].node)
        canvas.circle(at(node.p_W), 6.0, {ink::kBlack, 1.5, 1.0, ink::kWhite});
}

void FloorMap::draw(cv::Mat part, const MapPose& vehicle) {
  const cv::Point2d here = at(vehicle.p_W);
  if (!last_) last_ = here;
  const cv::Point2d moved = here - *last_;
  if (std::hypot(moved.x, moved.y) > 1.0) {
    Canvas(ground_, scale_).line(*last_, here, {ink::kBlue, 2.0});
    last_ = here;
  }
  ground_.copyTo(part);
  Canvas canvas(part, scale_);
  canvas.line(*last_, here, {ink::kBlue, 2.0});
  draw_vehicle(canvas, here, vehicle.heading_rad);
}

}  // namespace lineservo::apps
