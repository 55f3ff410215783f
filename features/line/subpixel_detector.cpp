#include "features/line/subpixel_detector.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "features/geometry/angles.h"
#include "features/line/mask_pixels.h"
#include "features/line/scene_check.h"
#include "features/line/stripe_detector.h"

namespace lineservo::features {
namespace {

constexpr double kMaskError = 3.0;      // of a coarse course, in mask pixels
constexpr double kWedge = 0.12;         // borders that converge lie so far off parallel ones
constexpr double kWedgeFacing = 0.94;   // cos 20°
constexpr double kLargestShift = 0.15;  // a refinement that goes further has found something else
constexpr double kLargestTurn_rad = radians(8.0);

// The mask with its holes and nicks of up to a fiftieth of its width filled: worn paint has edges of its own
// all over, which the search for stripes would take for borders. The image tells later where they are.
PackedMask filled(const PackedMask& mask) {
  const int side = 1 + 2 * std::max(1, mask.width() / 100);
  cv::Mat image = unpacked(mask);
  cv::morphologyEx(image, image, cv::MORPH_CLOSE, cv::getStructuringElement(cv::MORPH_RECT, {side, side}));
  return PackedMask::from_mat(image);
}

// Seen at a tilt that nobody tells, the borders converge: fitted to the mask's border first.
CurvedCourse wedge(const Stripe& stripe, const std::vector<BorderPoint>& border, const CurvedCourse& start) {
  const Eigen::Vector2d n = stripe.course.normal();
  std::vector<EdgePoint> points;
  for (const BorderPoint& point : border) {
    const double facing = point.normal.dot(n);
    if (std::abs(facing) < kWedgeFacing) continue;
    if (std::abs(border_residual(point, stripe.course, n)) > kWedge) continue;
    points.push_back({point.p_L, facing > 0.0 ? -1.0 : 1.0});
  }
  const auto fit = fit_borders(points, start, {.width = true, .taper = true}, kWedge, 0.01);
  return fit ? fit->course : start;
}

bool agrees(const CurvedCourse& refined, const CurvedCourse& start) {
  return std::abs(start.across(refined.foot)) < kLargestShift &&
         std::abs(wrap_angle(refined.theta_rad - start.theta_rad)) < kLargestTurn_rad;
}

}  // namespace

std::vector<DetectedLine> SubpixelDetector::detect(const LineScene& scene) {
  require_image(scene.image);
  if (!is_large_enough(scene.image)) return {};
  const CameraPose pose = scene.camera ? *scene.camera : StripeSearch::assumed_camera(scene.image.size());
  std::vector<DetectedLine> lines;
  for (const Stripe& stripe : search_.find(filled(scene.mask), pose, scene.prior)) {
    lines.push_back(refined(stripe, scene, pose));
    if (!scene.camera) lines.back().level.reset();
  }
  return lines;
}

DetectedLine SubpixelDetector::refined(const Stripe& stripe, const LineScene& scene,
                                       const CameraPose& pose) const {
  const StripeAxes axes(stripe.course);
  const double begin = axes.along(stripe.feature.begin.vector()),
               end = axes.along(stripe.feature.end.vector());
  const double middle = 0.5 * (begin + end);
  CurvedCourse start = CurvedCourse::straight(stripe.course, middle);
  const bool is_wedge = scene.camera == nullptr && stripe.both_borders;
  if (is_wedge) start = wedge(stripe, search_.border_points(), start);
  const double mask_pixel_px = static_cast<double>(scene.image.cols) / scene.mask.width();
  const auto course = refiner_.refine(scene.image, pose, start, {begin - middle, end - middle},
                                      kMaskError * mask_pixel_px, {.width = true, .taper = is_wedge});
  if (course && agrees(course->fit.course, start)) {
    const double quality = std::min(1.0, course->support);
    return view_course(course->fit, course->stretch, pose, quality);
  }
  DetectedLine coarse = view_stripe(stripe, pose);
  coarse.image.quality *= 0.5;
  coarse.level->quality *= 0.5;
  return coarse;
}

}  // namespace lineservo::features
