#include "features/line/border_check.h"

#include <algorithm>

namespace lineservo::features {
namespace {

constexpr double kStep = 0.02;
constexpr double kBeside = 0.015;         // of a border, to its sides: 3 mask pixels
constexpr double kLeastEdges = 0.8;       // of the places, for the first stripe of a frame
constexpr double kLeastFreeEdges = 0.65;  // for every further one
constexpr int kFewestEdges = 4;

bool holds(int edges, int paint_beyond, double least) {
  return edges >= least * (edges + paint_beyond);
}

}  // namespace

bool BorderCount::is_border_of_first() const {
  if (holds(edges, paint_beyond, kLeastEdges)) return true;
  const int uncrossed = edges - crossed_edges;
  if (uncrossed >= kFewestEdges && holds(uncrossed, paint_beyond - crossed_paint, kLeastEdges)) return true;
  return edges >= kFewestEdges && holds(edges, paint_beyond - covered, kLeastEdges);
}

bool BorderCount::is_border() const {
  return holds(edges, paint_beyond - covered, kLeastFreeEdges);
}

BorderCount BorderCheck::count(const LevelMask& mask, const StripeCourse& course, const Stretch& stretch,
                               const std::function<bool(const Eigen::Vector2d&)>& is_known) {
  const StripeAxes axes(course);
  const double half = 0.5 * course.width, off = std::min(kBeside, 0.25 * course.width);
  const auto paint = [&](double along, double across) { return mask.at(axes.at(along, across)); };
  sums_.assign(1, {});
  Sum sum;
  int run = 0;
  BorderCount count;
  for (double along = stretch.from; along <= stretch.to; along += kStep) {
    const Paint outside = paint(along, stretch.side * (half + off));
    const bool counts = outside != Paint::out_of_view &&
                        paint(along, stretch.side * (half - off)) == Paint::painted &&
                        !is_known(axes.at(along, stretch.side * (half + off)));
    if (counts && outside == Paint::painted) {
      ++sum.paint_beyond;
      run = paint(along, -stretch.side * (half + off)) == Paint::painted ? run + 1 : 0;
      count.covered = std::max(count.covered, run);
    } else if (counts) {
      ++sum.edges;
      run = 0;
    }
    sums_.push_back(sum);
  }
  count.edges = sum.edges;
  count.paint_beyond = sum.paint_beyond;
  find_crossing(static_cast<std::size_t>(course.width / kStep), count);
  return count;
}

void BorderCheck::find_crossing(std::size_t places, BorderCount& count) const {
  for (std::size_t last = 0; last < sums_.size(); ++last) {
    const Sum &from = sums_[last - std::min(places, last)], &to = sums_[last];
    if (to.paint_beyond - from.paint_beyond <= count.crossed_paint) continue;
    count.crossed_paint = to.paint_beyond - from.paint_beyond;
    count.crossed_edges = to.edges - from.edges;
  }
}

}  // namespace lineservo::features
