#pragma once

#include <Eigen/Core>
#include <vector>

#include "vehicle/floor/layout.h"

namespace lineservo::vehicle {

/// One straight or circular piece of a painted stripe, with how far its two butt ends are carried on past the
/// ends of the centreline.
struct Stripe {
  CurvePiece centreline;
  double width_m = 0.0;
  Bgr colour = {};
  double before_m = 0.0;
  double after_m = 0.0;
};

/// A disc that fills the notch where stripes meet.
struct JointDisc {
  Eigen::Vector2d p_W = Eigen::Vector2d::Zero();
  double radius_m = 0.0;
  Bgr colour = {};
};

/// All paint of a layout but its markers.
struct Stripes {
  std::vector<Stripe> pieces;     ///< in the order of the edges
  std::vector<JointDisc> joints;  ///< painted below the pieces
};

/// Cuts the edges of a layout into stripes and joins their ends. A joint is a node, or a corner inside a
/// polyline:
/// - a lone end stops at the node;
/// - two straight ends in line run on into each other by half a width (a wider one does not into a narrower);
/// - two straight ends at a right angle, when nothing runs straight through, run on by half of the other's
///   width, so that together they cover the whole square of an L corner; at a T or a cross the stub stops at
///   the node, inside the stripe that runs through;
/// - ends at any other angle, and an arc that meets anything but in line, stop at the node under a disc of
///   the (larger) stripe's width;
/// - an arc that goes on in line is a butt joint.
/// In line and right angle are meant to within 1°.
Stripes stripes_of(const Layout& layout);

}  // namespace lineservo::vehicle
