#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "features/geometry/camera_model.h"
#include "features/junction/junction_code.h"
#include "vehicle/floor/layout.h"

namespace lineservo::apps {

/// What a frame truly shows, by the rule of codes.md.
struct CodeTruth {
  features::JunctionCode code = features::JunctionCode::unrecognised;
  std::vector<features::JunctionCode>
      accepted;         ///< all codes that count as right; more than one when it is ambiguous
  bool scored = false;  ///< false for arcs, 45° corners and arms outside 25°

  bool ambiguous() const { return accepted.size() > 1; }
  bool accepts(features::JunctionCode c) const;
  void accept(features::JunctionCode c);
};

/// Tells the true code of a frame from the true pose and the layout, in the 400×400 frame.
class JunctionTruth {
 public:
  JunctionTruth(const vehicle::Layout& layout, const features::CameraModel& camera);

  /// `travel_m`: how far the vehicle moves between two frames; half of it widens the ambiguous band.
  CodeTruth at(const Eigen::Isometry3d& X_WB, double travel_m) const;

 private:
  struct Arm {
    double heading_rad;
    double width_m, length_m;
    bool straight;
  };
  struct Node {
    Eigen::Vector2d p_W;
    double half_square_m;
    std::vector<Arm> arms;
  };
  /// How much of an arm is in view, and on which side of the vehicle.
  struct ArmSight {
    bool features::Arms::*side;
    double seen_px;
    bool has_name;  ///< straight and within 25° of forward, left, back or right
  };
  using Polygon = std::vector<Eigen::Vector2d>;
  struct View;

  CodeTruth of_lines(const View& view, double band_px) const;
  CodeTruth of_node(const Node& node, const View& view, double band_px) const;
  ArmSight sight(const Node& node, const Arm& arm, const View& view) const;
  /// The rectangle that an arm covers beyond the node's square.
  Polygon beyond_node(const Node& node, const Arm& arm, const View& view) const;
  const Node* node_in_view(const View& view) const;
  int marker_pixels(const View& view) const;
  bool edge_in_view(const View& view) const;

  const vehicle::Layout& layout_;
  features::CameraModel camera_;
  std::vector<Node> nodes_;
};

}  // namespace lineservo::apps
