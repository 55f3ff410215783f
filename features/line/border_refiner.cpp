#include "features/line/border_refiner.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <vector>

namespace lineservo::features {
namespace {

constexpr double kClosest_px = 1.5;      // of two measurements on one border
constexpr double kLeastReach_px = 0.35;  // Tukey's cut-off never falls below this
constexpr double kLeastContrast = 6.0;   // of paint to floor, in levels of 255
constexpr double kSignificant = 5.0;     // standard deviations
constexpr double kLeastSag_px = 0.7;     // a bend of less is taken for straight
constexpr double kOneSided = 0.1;        // of the points: fewer on a border do not tell the width
constexpr int kFewest = 16;              // measured points

// A measurement of one border, and how many places on the borders were in view for it.
struct BorderSamples {
  std::vector<EdgePoint> points;
  int in_view = 0;

  bool shows_both_borders() const {
    const auto right =
        std::count_if(points.begin(), points.end(), [](const EdgePoint& p) { return p.side > 0.0; });
    const double share = static_cast<double>(right) / static_cast<double>(points.size());
    return share >= kOneSided && share <= 1.0 - kOneSided;
  }
};

// One course on one image.
class Measurement {
 public:
  Measurement(const cv::Mat& image, const CameraPose& pose)
      : image_(image), pose_(pose), pixel_(1.0 / pose.camera.parameters().fx_px) {}

  /// The length of a pixel on the normalised plane.
  double pixel() const { return pixel_; }

  std::optional<Eigen::Vector3d> paint_minus_floor(const CurvedCourse& course,
                                                   const CourseStretch& stretch) const {
    constexpr int places = 48;
    std::vector<Eigen::Vector3d> paint, floor;
    for (int k = 0; k < places; ++k) {
      const double along = stretch.from + (stretch.to - stretch.from) * (k + 0.5) / places;
      const double half = 0.5 * course.width_at(along), beyond = 1.3 * half + 6.0 * pixel_;
      for (const double across : {-0.5 * half, 0.0, 0.5 * half}) collect(course.at(along, across), paint);
      for (const double across : {-beyond, beyond}) collect(course.at(along, across), floor);
    }
    if (paint.empty() || floor.empty()) return std::nullopt;
    const Eigen::Vector3d difference = median(paint) - median(floor);
    if (difference.norm() < kLeastContrast) return std::nullopt;
    return difference;
  }

  BorderSamples sample(const EdgeGauge& gauge, const CurvedCourse& course, const CourseStretch& stretch,
                       int places, int reach_px) const {
    BorderSamples samples;
    for (int k = 0; k < places; ++k) {
      const double along = stretch.from + (stretch.to - stretch.from) * (k + 0.5) / places;
      const double half = 0.5 * course.width_at(along);
      for (const double side : {-1.0, 1.0}) {
        const PixelPoint at = project(pose_, course.at(along, side * half));
        const PixelPoint inner = project(pose_, course.at(along, side * (half - pixel_)));
        const Eigen::Vector2d into_paint = Eigen::Vector2d(inner.x - at.x, inner.y - at.y).normalized();
        if (!into_paint.allFinite() || !gauge.in_view(at, into_paint, reach_px)) continue;
        ++samples.in_view;
        const auto offset = gauge.locate(at, into_paint, reach_px);
        if (!offset) continue;
        const PixelPoint edge{at.x + *offset * into_paint.x(), at.y + *offset * into_paint.y()};
        samples.points.push_back({pose_.view.level(pose_.camera.normalize(edge)).vector(), side});
      }
    }
    return samples;
  }

  int width_px(const CurvedCourse& course, const CourseStretch& stretch) const {
    const double along = 0.5 * (stretch.from + stretch.to), half = 0.5 * course.width_at(along);
    const PixelPoint a = project(pose_, course.at(along, -half)), b = project(pose_, course.at(along, half));
    return static_cast<int>(std::min(1e6, std::hypot(a.x - b.x, a.y - b.y)));
  }

 private:
  void collect(const Eigen::Vector2d& p_L, std::vector<Eigen::Vector3d>& colours) const {
    const PixelPoint at = project(pose_, p_L);
    if (!(at.x > -0.5 && at.y > -0.5 && at.x < image_.cols - 0.5 && at.y < image_.rows - 0.5)) return;
    const int x = static_cast<int>(at.x + 0.5), y = static_cast<int>(at.y + 0.5);
    if (image_.channels() == 1) return colours.emplace_back(image_.ptr(y)[x], 0.0, 0.0), void();
    const std::uint8_t* bgr = image_.ptr(y) + 3 * x;
    colours.emplace_back(bgr[0], bgr[1], bgr[2]);
  }

  static Eigen::Vector3d median(std::vector<Eigen::Vector3d>& colours) {
    Eigen::Vector3d middle;
    const auto at = colours.begin() + static_cast<std::ptrdiff_t>(colours.size() / 2);
    for (int c = 0; c < 3; ++c) {
      std::nth_element(colours.begin(), at, colours.end(),
                       [c](const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return a[c] < b[c]; });
      middle[c] = (*at)[c];
    }
    return middle;
  }

  const cv::Mat& image_;
  const CameraPose& pose_;
  double pixel_;
};

// The course with its foot in the middle of the stretch, where direction and offset are least correlated.
void move_foot(CurvedCourse& course, CourseStretch& stretch) {
  const double middle = 0.5 * (stretch.from + stretch.to);
  const Eigen::Vector2d foot = course.at(middle, 0.0);
  course.theta_rad = course.theta_at(middle);
  course.width = course.width_at(middle);
  course.foot = foot;
  stretch.from -= middle;
  stretch.to -= middle;
}

// Curvature and taper only where they stand out of their own uncertainty and are large enough to be seen.
std::optional<CurvedFit> fit_significant(const BorderSamples& samples, const CurvedCourse& start,
                                         const CourseStretch& stretch, FreeShape shape, double reach,
                                         double pixel) {
  shape.width = shape.width && samples.shows_both_borders();
  shape.taper = shape.taper && shape.width;
  const double least = kLeastReach_px * pixel, length = stretch.to - stretch.from;
  CurvedCourse plain = start;
  plain.curvature = 0.0;
  if (!shape.taper) plain.taper = 0.0;
  const auto straight = fit_borders(samples.points, plain, shape, reach, least);
  shape.curvature = true;
  const auto bent = fit_borders(samples.points, start, shape, reach, least);
  if (!bent || !straight) return bent ? bent : straight;
  const double kappa = std::abs(bent->course.curvature);
  const bool significant =
      kappa > kSignificant * bent->curvature_sigma && kappa * length * length / 8.0 > kLeastSag_px * pixel &&
      (bent->supporters > straight->supporters * 1.05 || bent->scatter < 0.8 * straight->scatter);
  return significant ? bent : straight;
}

}  // namespace

BorderRefiner::BorderRefiner(const RefinerOptions& options) : options_(options) {
  if (options.passes < 1 || options.passes > 10)
    throw std::invalid_argument("refiner: passes must be 1 to 10");
  if (options.points_per_border < 16 || options.points_per_border > 10000)
    throw std::invalid_argument("refiner: points_per_border must be 16 to 10000");
  if (options.reach_px < 2 || options.reach_px > 24)
    throw std::invalid_argument("refiner: reach_px must be 2 to 24");
  if (!(options.least_support >= 0.0 && options.least_support <= 1.0))
    throw std::invalid_argument("refiner: least_support must be 0 to 1");
}

std::optional<RefinedCourse> BorderRefiner::refine(const cv::Mat& image, const CameraPose& pose,
                                                   const CurvedCourse& start, const CourseStretch& stretch,
                                                   double error_px, const FreeShape& shape) const {
  const Measurement measurement(image, pose);
  const auto colours = measurement.paint_minus_floor(start, stretch);
  if (!colours) return std::nullopt;
  const EdgeGauge gauge(image, *colours);
  const double pixel = measurement.pixel();
  const int places = std::clamp(static_cast<int>((stretch.to - stretch.from) / (kClosest_px * pixel)),
                                kFewest, options_.points_per_border);
  const int most_px = std::max(2, static_cast<int>(0.45 * measurement.width_px(start, stretch)));
  RefinedCourse refined{.fit = {.course = start}, .stretch = stretch};
  for (int pass = 0; pass < options_.passes; ++pass) {
    move_foot(refined.fit.course, refined.stretch);
    const double wanted_px = pass == 0 ? std::max<double>(options_.reach_px, error_px) : options_.reach_px;
    const int reach_px = std::min(static_cast<int>(wanted_px), most_px);
    const BorderSamples samples =
        measurement.sample(gauge, refined.fit.course, refined.stretch, places, reach_px);
    if (std::ssize(samples.points) < kFewest) return std::nullopt;
    const auto fit =
        fit_significant(samples, refined.fit.course, refined.stretch, shape, reach_px * pixel, pixel);
    if (!fit) return std::nullopt;
    refined.fit = *fit;
    refined.support = static_cast<double>(fit->supporters) / samples.in_view;
  }
  if (refined.support < options_.least_support) return std::nullopt;
  return refined;
}

}  // namespace lineservo::features
