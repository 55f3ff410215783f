#include "features/detect/wedge_lines.h"

#include <algorithm>
#include <cmath>

#include "features/line/stripe_extent.h"

namespace lineservo::features {
namespace {

constexpr double kCodeFrame_px = 400.0;  // the frame in which the code rule counts pixels

StripePerceptionOptions options_for(const MaskGeometry& geometry) {
  StripePerceptionOptions options;
  const double scale = std::min(geometry.width_px(), geometry.height_px()) / kCodeFrame_px;
  options.visibility.min_px *= scale;
  options.visibility.across_slack_px *= scale;
  return options;
}

double along_of(const StripeAxes& axes, const LevelPoint& point) {
  return axes.along(point.vector());
}

}  // namespace

bool WedgeLine::covers(const Eigen::Vector2d& p_L, double margin) const {
  const StripeAxes axes(wedge.course);
  const double along = axes.along(p_L);
  return along > begin - margin && along < end + margin &&
         std::abs(axes.across(p_L)) < 0.5 * width_at(along) + margin;
}

WedgeLineFinder::WedgeLineFinder(const MaskGeometry& geometry)
    : geometry_(geometry), stripes_(geometry, options_for(geometry)) {}

WedgeLines WedgeLineFinder::find(const PackedMask& mask) {
  const StripeFeatures& found = stripes_.observe(mask.view(), LevelView());
  const LevelMask level_mask(mask.view(), geometry_, LevelView());
  WedgeLines seen{.lines = {}, .junction = found.junction, .code = found.raw};
  for (const LineFeature& stripe : found.lines) seen.lines.push_back(refined(stripe, level_mask));
  return seen;
}

WedgeLine WedgeLineFinder::refined(const LineFeature& stripe, const LevelMask& mask) const {
  const StripeCourse parallel{stripe.theta_rad, stripe.rho, stripe.width};
  const StripeAxes axes(parallel);
  WedgeLine line{.wedge = {.course = parallel},
                 .begin = along_of(axes, stripe.begin),
                 .end = along_of(axes, stripe.end),
                 .quality = stripe.quality};
  const auto wedge = fit_wedge(stripes_.border_points(), parallel, line.begin, line.end);
  if (!wedge) return line;
  const StripeAxes wedge_axes(wedge->course);
  line.wedge = *wedge;
  line.begin = along_of(wedge_axes, stripe.begin);
  line.end = along_of(wedge_axes, stripe.end);
  if (line.begin > line.end) std::swap(line.begin, line.end);
  const double visible = border_in_view(mask, wedge_axes, line.begin, line.end);
  line.quality = std::min(1.0, wedge->support / std::max(visible, 1e-9));
  return line;
}

MaskGeometry assumed_geometry(int width_px, int height_px) {
  CameraParameters camera;
  camera.width_px = width_px;
  camera.height_px = height_px;
  camera.fx_px = camera.fy_px = 0.5 * width_px;
  camera.cx_px = 0.5 * (width_px - 1);
  camera.cy_px = 0.5 * (height_px - 1);
  return {CameraModel(camera), width_px, height_px};
}

}  // namespace lineservo::features
