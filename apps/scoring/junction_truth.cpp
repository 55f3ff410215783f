#include "apps/scoring/junction_truth.h"

#include <algorithm>
#include <cmath>

#include "apps/config/layout_topology.h"
#include "features/geometry/angles.h"
#include "features/geometry/level_view.h"
#include "features/junction/fpd.h"
#include "vehicle/floor/floor_truth.h"

namespace lineservo::apps {
namespace {

using features::Arms;
using features::JunctionCode;
using features::kPi;
using features::radians;
using Polygon = std::vector<Eigen::Vector2d>;

constexpr double kFrame_px = 400.0;
constexpr double kVisible_px = 20.0;
constexpr double kBand_px = 4.0;
constexpr double kArmTolerance_rad = radians(25.0);

/// Sutherland–Hodgman against one side: keeps where sign · (p[axis] − bound) ≤ 0.
Polygon clip(const Polygon& polygon, int axis, double bound, double sign) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double da = sign * (a[axis] - bound), db = sign * (b[axis] - bound);
    if (da <= 0.0) kept.push_back(a);
    if ((da < 0.0 && db > 0.0) || (da > 0.0 && db < 0.0)) kept.push_back(a + (b - a) * (da / (da - db)));
  }
  return kept;
}

Polygon clip_to_frame(Polygon polygon) {
  for (int axis = 0; axis < 2 && !polygon.empty(); ++axis) {
    polygon = clip(polygon, axis, -0.5, -1.0);
    if (!polygon.empty()) polygon = clip(polygon, axis, kFrame_px - 0.5, 1.0);
  }
  return polygon;
}

Eigen::Vector2d extent(const Polygon& polygon) {
  if (polygon.empty()) return Eigen::Vector2d::Zero();
  Eigen::Vector2d low = polygon.front(), high = low;
  for (const Eigen::Vector2d& p : polygon) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return high - low;
}

double area(const Polygon& polygon) {
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    twice += a.x() * b.y() - b.x() * a.y();
  }
  return 0.5 * std::abs(twice);
}

Eigen::Vector2d direction(double heading_rad) {
  return {std::cos(heading_rad), std::sin(heading_rad)};
}

CodeTruth sure(JunctionCode code) {
  return {code, {code}, true};
}

/// The readings that are possible with one more arm: seen, not seen, or within the band of the limit both.
std::vector<Arms> with_arm(const std::vector<Arms>& readings, bool Arms::*side, double seen_px,
                           double band_px) {
  const bool unsure = std::abs(seen_px - kVisible_px) <= band_px;
  std::vector<Arms> possible;
  for (Arms reading : readings) {
    if (unsure || seen_px < kVisible_px) possible.push_back(reading);
    reading.*side = true;
    if (unsure || seen_px >= kVisible_px) possible.push_back(reading);
  }
  return possible;
}

/// By how many pixels the start marker's count may be off: a rim of the band's width.
double marker_slack(int red, double band_px) {
  return red == 0 ? 0.0 : band_px * 2.0 * std::sqrt(kPi * red) + 1.0;
}

}  // namespace

/// The frame: from the floor to pixels of the 400×400 image.
struct JunctionTruth::View {
  const features::CameraModel& camera;
  Eigen::Isometry3d X_CW;
  double heading_rad;
  Eigen::Vector2d below_W;
  double height_m;

  View(const features::CameraModel& model, const Eigen::Isometry3d& X_WB) : camera(model) {
    Eigen::Isometry3d X_BC = Eigen::Isometry3d::Identity();
    X_BC.linear() = features::down_camera_R_BC();
    X_CW = (X_WB * X_BC).inverse();
    const Eigen::Matrix3d& R = X_WB.linear();
    heading_rad = std::atan2(R(1, 0), R(0, 0));
    below_W = X_WB.translation().head<2>();
    height_m = X_WB.translation().z();
  }

  Eigen::Vector2d pixel(const Eigen::Vector2d& p_W) const {
    const Eigen::Vector3d p_C = X_CW * Eigen::Vector3d(p_W.x(), p_W.y(), 0.0);
    const features::PixelPoint px = camera.project({p_C.x() / p_C.z(), p_C.y() / p_C.z()});
    return {(px.x + 0.5) * kFrame_px / camera.width_px() - 0.5,
            (px.y + 0.5) * kFrame_px / camera.height_px() - 0.5};
  }

  Polygon visible(Polygon floor) const {
    for (Eigen::Vector2d& p : floor) p = pixel(p);
    return clip_to_frame(std::move(floor));
  }

  /// Half of what the camera could see across, generously: beyond it nothing can be in view.
  double reach_m() const {
    return 2.5 * height_m * camera.width_px() / (2.0 * camera.parameters().fx_px) + 0.5;
  }

  double pixels_a_metre() const {
    return camera.parameters().fy_px / height_m * kFrame_px / camera.height_px();
  }
};

void CodeTruth::accept(JunctionCode c) {
  if (!accepts(c)) accepted.push_back(c);
}

bool CodeTruth::accepts(JunctionCode c) const {
  return std::find(accepted.begin(), accepted.end(), c) != accepted.end();
}

JunctionTruth::JunctionTruth(const vehicle::Layout& layout, const features::CameraModel& camera)
    : layout_(layout), camera_(camera) {
  for (const vehicle::LayoutNode& node : layout.nodes) nodes_.push_back({node.p_W, 0.0, {}});
  for (const vehicle::LayoutEdge& edge : layout.edges) {
    const double length_m = edge.centreline.length_m();
    const bool straight =
        edge.centreline.pieces().size() == 1 && edge.centreline.pieces()[0].curvature_inv_m == 0.0;
    nodes_[edge.from].arms.push_back({edge.centreline.at(0.0).heading_rad, edge.width_m, length_m, straight});
    nodes_[edge.to].arms.push_back(
        {edge.centreline.at(length_m).heading_rad + kPi, edge.width_m, length_m, straight});
    for (const std::size_t end : {edge.from, edge.to}) {
      nodes_[end].half_square_m = std::max(nodes_[end].half_square_m, 0.5 * edge.width_m);
    }
  }
}

const JunctionTruth::Node* JunctionTruth::node_in_view(const View& view) const {
  const Node* nearest = nullptr;
  double nearest_px = 1e9;
  for (const Node& node : nodes_) {
    if ((node.p_W - view.below_W).norm() > view.reach_m() || node.arms.empty()) continue;
    const double h = node.half_square_m;
    const Eigen::Vector2d x = h * direction(node.arms.front().heading_rad), y(-x.y(), x.x());
    if (view.visible({node.p_W + x + y, node.p_W - x + y, node.p_W - x - y, node.p_W + x - y}).empty())
      continue;
    const double px = (view.pixel(node.p_W) - Eigen::Vector2d::Constant(0.5 * (kFrame_px - 1.0))).norm();
    if (px < nearest_px) nearest_px = px, nearest = &node;
  }
  return nearest;
}

int JunctionTruth::marker_pixels(const View& view) const {
  double total = 0.0;
  for (const vehicle::LayoutMarker& marker : red_discs(layout_)) {
    if ((marker.p_W - view.below_W).norm() > view.reach_m() + marker.radius_m) continue;
    Polygon disc;
    constexpr int kSides = 72;
    for (int i = 0; i < kSides; ++i)
      disc.push_back(marker.p_W + marker.radius_m * direction(2.0 * kPi * i / kSides));
    total += area(view.visible(std::move(disc)));
  }
  return static_cast<int>(total);
}

bool JunctionTruth::edge_in_view(const View& view) const {
  const double half_view_m = 0.4 * view.height_m * camera_.width_px() / camera_.parameters().fx_px;
  return vehicle::distance_to_paint_m(layout_, view.below_W) < half_view_m;
}

JunctionTruth::ArmSight JunctionTruth::sight(const Node& node, const Arm& arm, const View& view) const {
  static constexpr bool Arms::*kSides[] = {&Arms::forward, &Arms::left, &Arms::back, &Arms::right};
  const double relative_rad = features::wrap_angle(arm.heading_rad - view.heading_rad);
  const double quarter = std::round(relative_rad / (kPi / 2.0));
  const bool has_name = arm.straight && std::abs(relative_rad - quarter * kPi / 2.0) <= kArmTolerance_rad;
  return {kSides[(static_cast<int>(quarter) + 4) % 4],
          extent(view.visible(beyond_node(node, arm, view))).minCoeff(), has_name};
}

JunctionTruth::Polygon JunctionTruth::beyond_node(const Node& node, const Arm& arm, const View& view) const {
  const Eigen::Vector2d along = direction(arm.heading_rad), across(-along.y(), along.x());
  const double reach_m = std::max(std::min(arm.length_m, 2.0 * view.reach_m()), node.half_square_m);
  const Eigen::Vector2d near = node.p_W + node.half_square_m * along;
  const Eigen::Vector2d far = node.p_W + reach_m * along;
  const Eigen::Vector2d side = 0.5 * arm.width_m * across;
  return {near + side, near - side, far - side, far + side};
}

CodeTruth JunctionTruth::of_node(const Node& node, const View& view, double band_px) const {
  CodeTruth truth;
  truth.scored = true;
  Arms certain;
  std::vector<Arms> readings = {Arms{}};
  for (const Arm& arm : node.arms) {
    const ArmSight seen = sight(node, arm, view);
    truth.scored &= seen.has_name;
    if (seen.seen_px >= kVisible_px) certain.*seen.side = true;
    readings = with_arm(readings, seen.side, seen.seen_px, band_px);
  }
  truth.code = code_of(certain);
  for (const Arms& reading : readings) truth.accept(code_of(reading));
  return truth;
}

CodeTruth JunctionTruth::of_lines(const View& view, double band_px) const {
  if (const Node* node = node_in_view(view)) return of_node(*node, view, band_px);
  return sure(edge_in_view(view) ? JunctionCode::straight : JunctionCode::unrecognised);
}

CodeTruth JunctionTruth::at(const Eigen::Isometry3d& X_WB, double travel_m) const {
  const View view(camera_, X_WB);
  const double band_px = std::max(kBand_px, 0.5 * travel_m * view.pixels_a_metre());
  const int red = marker_pixels(view);
  const double slack = marker_slack(red, band_px);
  if (red > features::kStartMarkerLimit_px + slack) return sure(JunctionCode::start);
  CodeTruth truth = of_lines(view, band_px);
  if (red > features::kStartMarkerLimit_px) truth.code = JunctionCode::start;
  if (red > features::kStartMarkerLimit_px - slack) truth.accept(JunctionCode::start);
  return truth;
}

}  // namespace lineservo::apps
