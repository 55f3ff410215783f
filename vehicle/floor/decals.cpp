#include "vehicle/floor/decals.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "features/geometry/angles.h"
#include "vehicle/floor/floor_truth.h"
#include "vehicle/random.h"

namespace lineservo::vehicle {
namespace {

using Eigen::Vector2d;
using features::kPi;

constexpr double kSquare_m = 1.0;
constexpr double kLargestReach_m = 0.25;  // of any decal in a square from its centre
constexpr double kBlotchInWidths = 1.0 / 6.0, kSmallestBlotch_m = 0.0125, kLargestBlotch_m = 0.03;
constexpr double kSpotRadius_m = 0.025;
constexpr double kObjectsClearance_m = 0.03;
constexpr double kGapClearance_m = 0.3;  // from a node, past the line that crosses there
constexpr double kGapOverhang_m = 0.02;  // past the line's borders

enum Stream : std::uint64_t { kBlotches = 301, kSpots, kObjects, kGaps };

Random of_square(std::uint64_t seed, Stream stream, int x, int y) {
  const auto low = static_cast<std::uint64_t>(static_cast<std::uint32_t>(x));
  const auto high = static_cast<std::uint64_t>(static_cast<std::uint32_t>(y));
  return Random(Random(seed, stream).bits(), (high << 32) | low);
}

// Knuth's product of uniforms, in portions that keep exp(−λ) above the smallest number.
int poisson(double mean, Random& random) {
  int count = 0;
  for (; mean > 0.0; mean -= 100.0) {
    const double limit = std::exp(-std::min(mean, 100.0));
    for (double product = random.uniform(); product > limit; product *= random.uniform()) ++count;
  }
  return count;
}

// Radii are uniform from a half to one and a half of the middle one: E[r²] = (1 + 1/12) r².
double drawn_radius_m(double middle_m, Random& random) {
  return random.uniform(0.5, 1.5) * middle_m;
}

// λ of 1 − share = exp(−λ π E[r²])
double density_per_m2(double share, double middle_radius_m) {
  return -std::log1p(-share) / (kPi * (13.0 / 12.0) * middle_radius_m * middle_radius_m);
}

Vector2d drawn_place_W(int x, int y, Random& random) {
  const double along = random.uniform(), up = random.uniform();
  return {(x + along) * kSquare_m, (y + up) * kSquare_m};
}

Bgr drawn_dirt(Random& random) {
  const auto grey = static_cast<std::uint8_t>(random.uniform(45.0, 85.0));
  return {grey, static_cast<std::uint8_t>(grey + 4), static_cast<std::uint8_t>(grey + 10)};
}

// Blue, green, white and black tape; brown and grey boxes.
struct ObjectKind {
  Bgr colour;
  double length_m, width_m;
};
constexpr ObjectKind kObjectKinds[] = {
    {{170, 70, 20}, 0.30, 0.05}, {{60, 140, 30}, 0.30, 0.05}, {{235, 235, 235}, 0.30, 0.05},
    {{25, 25, 25}, 0.30, 0.05},  {{60, 95, 140}, 0.22, 0.14}, {{90, 90, 90}, 0.12, 0.10},
};

double narrowest_m(const Layout& layout) {
  double width_m = layout.edges.front().width_m;
  for (const LayoutEdge& edge : layout.edges) width_m = std::min(width_m, edge.width_m);
  return width_m;
}

bool within(double value, double low, double high) {
  return value >= low && value <= high;
}

}  // namespace

Decals::Decal Decals::disc(const Vector2d& centre_W, double radius_m, const Bgr& colour) {
  PaintBorder border;
  border.kind = PaintBorder::Kind::inside_circle;
  border.centre_W = centre_W;
  border.radius_m = radius_m;
  return {{colour, {border}}, centre_W, radius_m};
}

Decals::Decal Decals::rectangle(const Vector2d& centre_W, double heading_rad, double length_m, double width_m,
                                const Bgr& colour) {
  const Vector2d u(std::cos(heading_rad), std::sin(heading_rad)), left(-u.y(), u.x());
  PaintShape shape{colour, {}};
  for (const auto& [n_W, half_m] : {std::pair<Vector2d, double>{u, 0.5 * length_m},
                                    {-u, 0.5 * length_m},
                                    {left, 0.5 * width_m},
                                    {-left, 0.5 * width_m}}) {
    PaintBorder border;
    border.n_W = n_W;
    border.offset_m = half_m + n_W.dot(centre_W);
    shape.borders.push_back(border);
  }
  return {shape, centre_W, 0.5 * std::hypot(length_m, width_m)};
}

Decals::Decal Decals::drawn_object(const Vector2d& centre_W, Random& random) {
  const auto kind =
      static_cast<std::size_t>(random.uniform(0.0, static_cast<double>(std::size(kObjectKinds))));
  const double size = random.uniform(0.7, 1.3), heading_rad = random.uniform(0.0, kPi);
  const ObjectKind& made = kObjectKinds[kind];
  return rectangle(centre_W, heading_rad, size * made.length_m, size * made.width_m, made.colour);
}

void WearOptions::validate() const {
  if (!within(worn_share, 0.0, 0.9)) throw std::invalid_argument("wear: the worn share must be 0 to 0.9");
  if (!within(gap_m, 0.0, 1.0)) throw std::invalid_argument("wear: gaps must be 0 to 1 m long");
  if (!within(gap_every_m, 0.2, 1000.0))
    throw std::invalid_argument("wear: the way between gaps must be 0.2 to 1000 m");
  if (!within(dirt_share, 0.0, 0.5)) throw std::invalid_argument("wear: the share of dirt must be 0 to 0.5");
  if (!within(objects_per_m2, 0.0, 20.0))
    throw std::invalid_argument("wear: there must be 0 to 20 objects per m²");
}

Decals::Decals(const Layout& layout, const WearOptions& options, std::uint64_t seed,
               const RepaintOptions& repainted)
    : layout_(layout),
      options_(options),
      seed_(seed),
      blotch_radius_m_(
          std::clamp(kBlotchInWidths * narrowest_m(layout), kSmallestBlotch_m, kLargestBlotch_m)) {
  options.validate();
  repaint(repainted);
  if (options.gap_m > 0.0) cut_gaps();
}

void RepaintOptions::validate() const {
  if (!cover_W.allFinite() || !branch_W.allFinite() || !std::isfinite(branch_heading_rad))
    throw std::invalid_argument("repaint: places and headings must be finite");
  if (!within(cover_radius_m, 0.0, 100.0))
    throw std::invalid_argument("repaint: the cover's radius must be 0 to 100 m");
  if (!within(branch_length_m, 0.0, 100.0))
    throw std::invalid_argument("repaint: the branch must be 0 to 100 m long");
}

void Decals::repaint(const RepaintOptions& options) {
  options.validate();
  if (options.cover_radius_m > 0.0)
    lasting_.push_back(disc(options.cover_W, options.cover_radius_m, layout_.floor_colour));
  if (!(options.branch_length_m > 0.0)) return;
  const LayoutEdge& like = layout_.edges.front();
  const Vector2d along_W(std::cos(options.branch_heading_rad), std::sin(options.branch_heading_rad));
  lasting_.push_back(rectangle(options.branch_W + 0.5 * options.branch_length_m * along_W,
                               options.branch_heading_rad, options.branch_length_m, like.width_m,
                               like.colour));
}

bool Decals::is_none() const {
  return options_.worn_share == 0.0 && options_.dirt_share == 0.0 && options_.objects_per_m2 == 0.0 &&
         lasting_.empty();
}

// Gap k of a line lies somewhere in the middle 60 % of the line's k-th stretch, unless that is near a node.
void Decals::cut_gaps() {
  for (std::size_t e = 0; e < layout_.edges.size(); ++e) {
    const LayoutEdge& edge = layout_.edges[e];
    const double clear_m = 0.5 * edge.width_m + kGapClearance_m + 0.5 * options_.gap_m;
    for (int k = 0; k * options_.gap_every_m < edge.centreline.length_m(); ++k) {
      Random random = of_square(seed_, kGaps, static_cast<int>(e), k);
      const double s_m = (k + random.uniform(0.2, 0.8)) * options_.gap_every_m;
      if (s_m < clear_m || s_m > edge.centreline.length_m() - clear_m) continue;
      const CurvePoint middle = edge.centreline.at(s_m);
      lasting_.push_back(rectangle(middle.p_W, middle.heading_rad, options_.gap_m,
                                   edge.width_m + 2.0 * kGapOverhang_m, layout_.floor_colour));
    }
  }
}

void Decals::draw_blotches(const Square& square, const Layout& paint, std::vector<Decal>& holes) const {
  const auto& [x, y] = square;
  Random random = of_square(seed_, kBlotches, x, y);
  const double density = density_per_m2(options_.worn_share, blotch_radius_m_);
  for (int n = poisson(density * kSquare_m * kSquare_m, random); n > 0; --n) {
    const Vector2d p_W = drawn_place_W(x, y, random);
    const double radius_m = drawn_radius_m(blotch_radius_m_, random);
    if (distance_to_paint_m(paint, p_W) < radius_m)
      holes.push_back(disc(p_W, radius_m, layout_.floor_colour));
  }
}

void Decals::draw_objects(const Square& square, const Layout& paint, std::vector<Decal>& on_top) const {
  const auto& [x, y] = square;
  Random random = of_square(seed_, kObjects, x, y);
  for (int n = poisson(options_.objects_per_m2 * kSquare_m * kSquare_m, random); n > 0; --n) {
    const Vector2d p_W = drawn_place_W(x, y, random);
    const Decal object = drawn_object(p_W, random);
    if (distance_to_paint_m(paint, p_W) > object.reach_m + kObjectsClearance_m) on_top.push_back(object);
  }
}

void Decals::draw_spots(const Square& square, std::vector<Decal>& on_top) const {
  const auto& [x, y] = square;
  Random random = of_square(seed_, kSpots, x, y);
  const double density = density_per_m2(options_.dirt_share, kSpotRadius_m);
  for (int n = poisson(density * kSquare_m * kSquare_m, random); n > 0; --n) {
    const Vector2d p_W = drawn_place_W(x, y, random);
    const double radius_m = drawn_radius_m(kSpotRadius_m, random);
    on_top.push_back(disc(p_W, radius_m, drawn_dirt(random)));
  }
}

// What of the paint matters for decals with their centres in the square.
Layout Decals::paint_near(const Square& square) const {
  const Vector2d middle_W(kSquare_m * (square.first + 0.5), kSquare_m * (square.second + 0.5));
  Layout paint;
  paint.start_markers = layout_.start_markers;
  paint.end_markers = layout_.end_markers;
  for (const LayoutEdge& edge : layout_.edges)
    if (edge.centreline.project(middle_W).distance_m < kSquare_m + kLargestReach_m + edge.width_m)
      paint.edges.push_back(edge);
  return paint;
}

const Decals::Content& Decals::content(const Square& square) {
  const auto [it, is_new] = squares_.try_emplace(square);
  if (is_new) {
    const Layout paint = paint_near(square);
    draw_blotches(square, paint, it->second.holes);
    draw_objects(square, paint, it->second.on_top);
    draw_spots(square, it->second.on_top);
  }
  return it->second;
}

void Decals::look_near(const Vector2d& p_W, double radius_m) {
  holes_.clear();
  on_top_.clear();
  const auto take = [&](const std::vector<Decal>& decals, std::vector<const PaintShape*>& into) {
    for (const Decal& decal : decals)
      if ((decal.centre_W - p_W).squaredNorm() < std::pow(radius_m + decal.reach_m, 2))
        into.push_back(&decal.shape);
  };
  take(lasting_, holes_);
  const double reach_m = radius_m + kLargestReach_m;
  const auto square_at = [](double c) { return static_cast<int>(std::floor(c / kSquare_m)); };
  for (int x = square_at(p_W.x() - reach_m); x <= square_at(p_W.x() + reach_m); ++x)
    for (int y = square_at(p_W.y() - reach_m); y <= square_at(p_W.y() + reach_m); ++y) {
      const Content& here = content({x, y});
      take(here.holes, holes_);
      take(here.on_top, on_top_);
    }
}

}  // namespace lineservo::vehicle
