#include "vehicle/floor/stripes.h"

#include <algorithm>
#include <cmath>

#include "features/geometry/angles.h"

namespace lineservo::vehicle {
namespace {

using Eigen::Vector2d;
using features::kPi;

// Butt joints overlap by this much, so that rounding leaves no gap.
constexpr double kSeamOverlap_m = 1e-4;
const double kAngleTolerance = std::sin(features::radians(1.0));

// One end of a stripe at a joint.
struct End {
  std::size_t stripe = 0;
  bool is_last = false;  ///< the end of its centreline, not the start
  Vector2d p_W;
  Vector2d leaving_W;  ///< unit vector along the stripe, away from the joint
  double width_m = 0.0;
  bool is_straight = true;
  Bgr colour = {};
};

using Joint = std::vector<End>;

Vector2d direction(double heading_rad) {
  return {std::cos(heading_rad), std::sin(heading_rad)};
}

End first_end(const Stripes& stripes, std::size_t i) {
  const Stripe& s = stripes.pieces[i];
  return {i,
          false,
          s.centreline.start_W,
          direction(s.centreline.heading_rad),
          s.width_m,
          s.centreline.curvature_inv_m == 0.0,
          s.colour};
}

End last_end(const Stripes& stripes, std::size_t i, const CurvePoint& end) {
  const Stripe& s = stripes.pieces[i];
  return {i,       true, end.p_W, -direction(end.heading_rad), s.width_m, s.centreline.curvature_inv_m == 0.0,
          s.colour};
}

bool in_line(const End& a, const End& b) {
  return a.leaving_W.dot(b.leaving_W) < -std::sqrt(1.0 - kAngleTolerance * kAngleTolerance);
}

bool square(const End& a, const End& b) {
  return a.is_straight && b.is_straight && std::abs(a.leaving_W.dot(b.leaving_W)) < kAngleTolerance;
}

// Width of the widest stripe that runs straight through the joint; 0 when none does.
double through_width_m(const Joint& joint) {
  double widest_m = 0.0;
  for (std::size_t i = 0; i < joint.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (in_line(joint[i], joint[j]))
        widest_m = std::max(widest_m, std::min(joint[i].width_m, joint[j].width_m));
  return widest_m;
}

double overrun_m(const End& end, const Joint& joint) {
  if (joint.size() < 2) return 0.0;
  const bool has_through = through_width_m(joint) > 0.0;
  double overrun_m = kSeamOverlap_m;
  for (const End& other : joint) {
    const bool carries_on =
        end.is_straight && other.is_straight && in_line(end, other) && end.width_m <= other.width_m;
    const bool makes_a_corner = square(end, other) && !has_through;
    if (carries_on || makes_a_corner) overrun_m = std::max(overrun_m, 0.5 * other.width_m);
  }
  return overrun_m;
}

// The disc under the ends that meet at an angle other than 90° and 180°; its radius is 0 when none is needed.
JointDisc disc_of(const Joint& joint) {
  JointDisc disc;
  const double through_m = through_width_m(joint);
  for (const End& a : joint)
    for (const End& b : joint) {
      if (&a == &b || in_line(a, b) || square(a, b)) continue;
      const End& wider = a.width_m >= b.width_m ? a : b;
      if (wider.width_m > through_m && 0.5 * wider.width_m > disc.radius_m)
        disc = {wider.p_W, 0.5 * wider.width_m, wider.colour};
    }
  return disc;
}

void join(const Joint& joint, Stripes& stripes) {
  for (const End& end : joint) {
    Stripe& stripe = stripes.pieces[end.stripe];
    (end.is_last ? stripe.after_m : stripe.before_m) = overrun_m(end, joint);
  }
  if (const JointDisc disc = disc_of(joint); disc.radius_m > 0.0) stripes.joints.push_back(disc);
}

// An arc of more than half a turn, short of a whole one, is cut in two: each is then convex between its ends.
std::vector<CurvePiece> cut(const Curve& curve) {
  std::vector<CurvePiece> pieces;
  double begin_m = 0.0;
  for (CurvePiece piece : curve.pieces()) {
    const double turn_rad = std::abs(piece.curvature_inv_m) * piece.length_m;
    if (turn_rad > kPi && turn_rad < 2.0 * kPi - 1e-9) {
      piece.length_m *= 0.5;
      pieces.push_back(piece);
      const CurvePoint middle = curve.at(begin_m + piece.length_m);
      begin_m += piece.length_m;
      piece.start_W = middle.p_W;
      piece.heading_rad = middle.heading_rad;
    }
    pieces.push_back(piece);
    begin_m += piece.length_m;
  }
  return pieces;
}

// Adds the pieces of an edge, joins them to each other, and leaves its two outer ends at its nodes' joints.
void add_edge(const LayoutEdge& edge, Stripes& stripes, std::vector<Joint>& nodes) {
  const Curve& curve = edge.centreline;
  Joint open = {};
  double end_m = 0.0;
  for (const CurvePiece& piece : cut(curve)) {
    const std::size_t i = stripes.pieces.size();
    stripes.pieces.push_back({piece, edge.width_m, edge.colour});
    end_m += piece.length_m;
    CurvePoint end = curve.at(end_m);
    // At a corner at() may answer with the next piece's heading: take this piece's own.
    end.heading_rad = piece.heading_rad + piece.curvature_inv_m * piece.length_m;
    if (open.empty()) {
      nodes[edge.from].push_back(first_end(stripes, i));
    } else {
      join({open.front(), first_end(stripes, i)}, stripes);
    }
    open = {last_end(stripes, i, end)};
  }
  if (!open.empty()) nodes[edge.to].push_back(open.front());
}

}  // namespace

Stripes stripes_of(const Layout& layout) {
  Stripes stripes;
  std::vector<Joint> nodes(layout.nodes.size());
  for (const LayoutEdge& edge : layout.edges) add_edge(edge, stripes, nodes);
  for (const Joint& joint : nodes) join(joint, stripes);
  return stripes;
}

}  // namespace lineservo::vehicle
