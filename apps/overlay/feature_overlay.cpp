#include "apps/overlay/feature_overlay.h"

#include <opencv2/imgproc.hpp>

#include "apps/overlay/frame_projection.h"
#include "apps/overlay/ink.h"

namespace lineservo::apps {
namespace {

using features::LevelPoint;

/// Contours that end with the frame go along its border, where no outline is to be seen.
bool along_border(cv::Point a, cv::Point b, const features::PackedMask& mask) {
  const auto both = [](int p, int q, int side) { return p == side && q == side; };
  return both(a.x, b.x, 0) || both(a.y, b.y, 0) || both(a.x, b.x, mask.width() - 1) ||
         both(a.y, b.y, mask.height() - 1);
}

void draw_outline(Canvas& canvas, const features::PackedMask& mask, cv::Size frame) {
  std::vector<std::vector<cv::Point>> contours;
  cv::findContours(mask.to_mat(), contours, cv::RETR_LIST, cv::CHAIN_APPROX_SIMPLE);
  const double sx = static_cast<double>(frame.width) / mask.width(),
               sy = static_cast<double>(frame.height) / mask.height();
  const auto at = [&](cv::Point p) { return cv::Point2d((p.x + 0.5) * sx - 0.5, (p.y + 0.5) * sy - 0.5); };
  for (const std::vector<cv::Point>& contour : contours) {
    for (std::size_t k = 0; k < contour.size(); ++k) {
      const cv::Point a = contour[k], b = contour[(k + 1) % contour.size()];
      if (!along_border(a, b, mask)) canvas.line(at(a), at(b), {ink::kSky, 1.0});
    }
  }
}

void draw_line(Canvas& canvas, const features::LineFeature& line, const FrameProjection& projection,
               const Stroke& stroke) {
  canvas.polyline(projection.stretch(line.begin, line.end, line.curvature, line.theta_rad), stroke);
}

/// The one to follow, with its ends.
void draw_followed(Canvas& canvas, const features::LineFeature& line, const FrameProjection& projection,
                   const cv::Scalar& colour) {
  const Stroke stroke{colour, 2.0, 1.0, ink::kWhite};
  draw_line(canvas, line, projection, stroke);
  if (const auto begin = projection.at(line.begin)) canvas.circle(*begin, 5.0, stroke);
  if (const auto end = projection.at(line.end)) {
    canvas.disc(*end, 6.0, ink::kWhite);
    canvas.disc(*end, 5.0, colour);
  }
}

// An arm at the angle α, counter-clockwise from forward, leads to −(sin α, cos α) in L.
void draw_junction(Canvas& canvas, const OverlayScene& scene, const FrameProjection& projection) {
  const features::JunctionFeature& junction = *scene.features.junction;
  const LevelPoint c = junction.centre;
  for (const features::ArmFeature& arm : junction.arms) {
    const LevelPoint tip{c.x - arm.length * std::sin(arm.angle_rad),
                         c.y - arm.length * std::cos(arm.angle_rad)};
    canvas.polyline(projection.stretch(c, tip), {ink::kVermilion, 2.0, 1.0, ink::kWhite});
  }
  const auto centre = projection.at(c);
  if (!centre) return;
  canvas.disc(*centre, 6.0, ink::kWhite);
  canvas.disc(*centre, 5.0, ink::kVermilion);
  canvas.circle(*centre, 11.0, {ink::kVermilion, 2.0, 1.0, ink::kWhite});
  canvas.text(*centre + canvas.scale() * cv::Point2d(18.0, -16.0),
              std::string(name(scene.features.code.smoothed)), 15.0, {ink::kWhite, 2.0, 1.5, ink::kBlack});
}

void draw_cross(Canvas& canvas, cv::Point2d at, double radius_px, const Stroke& stroke) {
  const double r = radius_px * canvas.scale();
  canvas.line({at.x - r, at.y}, {at.x + r, at.y}, stroke);
  canvas.line({at.x, at.y - r}, {at.x, at.y + r}, stroke);
}

void draw_diamond(Canvas& canvas, cv::Point2d at, double radius_px, const cv::Scalar& colour) {
  const double r = radius_px * canvas.scale();
  canvas.polygon({{at.x, at.y - r}, {at.x + r, at.y}, {at.x, at.y + r}, {at.x - r, at.y}}, colour);
}

void draw_law_features(Canvas& canvas, const features::LawFeatures& law, const FrameProjection& projection) {
  if (!law.lines.empty()) draw_followed(canvas, law.lines.front(), projection, ink::kOrange);
  if (law.centroid)
    if (const auto at = projection.at(*law.centroid))
      draw_cross(canvas, *at, 9.0, {ink::kGreen, 3.0, 1.0, ink::kWhite});
  if (law.target)
    if (const auto at = projection.at(*law.target)) {
      draw_diamond(canvas, *at, 11.0, ink::kWhite);
      draw_diamond(canvas, *at, 9.0, ink::kPurple);
    }
}

}  // namespace

void draw_features(Canvas& canvas, const features::CameraModel& camera, const OverlayScene& scene, int zoom) {
  const features::FrameFeatures& seen = scene.features;
  const FrameProjection projection(camera, scene.view, zoom);
  if (scene.mask) draw_outline(canvas, *scene.mask, {camera.width_px() * zoom, camera.height_px() * zoom});
  for (std::size_t k = 1; k < seen.lines.size(); ++k)
    draw_line(canvas, seen.lines[k], projection, {ink::kBlue, 1.0, 1.0, ink::kWhite});
  if (seen.line()) draw_followed(canvas, *seen.line(), projection, ink::kBlue);
  if (seen.junction) draw_junction(canvas, scene, projection);
  draw_law_features(canvas, seen.law, FrameProjection(camera, scene.law_view, zoom));
}

}  // namespace lineservo::apps
