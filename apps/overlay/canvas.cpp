#include "apps/overlay/canvas.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace lineservo::apps {
namespace {

constexpr int kShift = 4;  // OpenCV's fixed point: sixteenths of a pixel
constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;
constexpr double kFontHeight_px = 21.0;  // of its capitals, at scale 1
// What lies farther out is left out: fixed point overflows.
constexpr double kFarthest_px = 16000.0;

cv::Point fixed(cv::Point2d p) {
  const double one = 1 << kShift;
  return {static_cast<int>(std::lround(p.x * one)), static_cast<int>(std::lround(p.y * one))};
}

bool is_near(cv::Point2d p) {
  return std::abs(p.x) < kFarthest_px && std::abs(p.y) < kFarthest_px;
}

int whole(double width_px) {
  return std::max(1, static_cast<int>(std::lround(width_px)));
}

void draw_line(cv::Mat& picture, cv::Point2d a, cv::Point2d b, const cv::Scalar& colour, double width_px) {
  cv::line(picture, fixed(a), fixed(b), colour, whole(width_px), cv::LINE_AA, kShift);
}

}  // namespace

void Canvas::polyline(const std::vector<cv::Point2d>& points, const Stroke& stroke) {
  const auto draw = [&](const cv::Scalar& colour, double width_px) {
    for (std::size_t k = 1; k < points.size(); ++k)
      if (is_near(points[k - 1]) && is_near(points[k]))
        draw_line(picture_, points[k - 1], points[k], colour, width_px * scale_);
  };
  if (stroke.rim_px > 0.0) draw(stroke.rim, stroke.width_px + 2.0 * stroke.rim_px);
  draw(stroke.colour, stroke.width_px);
}

void Canvas::arrow(cv::Point2d from, cv::Point2d to, const Stroke& stroke, double head_px) {
  const cv::Point2d way = to - from;
  const double length_px = std::hypot(way.x, way.y);
  if (!(length_px > 0.0) || !is_near(from) || !is_near(to)) return;
  const cv::Point2d along = way / length_px, across{-along.y, along.x};
  const double head = std::min(head_px * scale_, length_px), rim = stroke.rim_px * scale_;
  const auto triangle = [&](double grown) {
    const cv::Point2d foot = to - (head + grown) * along, half = (0.55 * head + grown) * across;
    return std::vector<cv::Point2d>{to + 1.5 * grown * along, foot + half, foot - half};
  };
  const cv::Point2d neck = to - 0.8 * head * along;
  if (rim > 0.0) {
    draw_line(picture_, from, neck, stroke.rim, stroke.width_px * scale_ + 2.0 * rim);
    polygon(triangle(rim), stroke.rim);
  }
  draw_line(picture_, from, neck, stroke.colour, stroke.width_px * scale_);
  polygon(triangle(0.0), stroke.colour);
}

void Canvas::circle(cv::Point2d centre, double radius_px, const Stroke& stroke) {
  if (!is_near(centre)) return;
  const int radius = whole(radius_px * scale_ * (1 << kShift));
  const auto draw = [&](const cv::Scalar& colour, double width_px) {
    cv::circle(picture_, fixed(centre), radius, colour, whole(width_px * scale_), cv::LINE_AA, kShift);
  };
  if (stroke.rim_px > 0.0) draw(stroke.rim, stroke.width_px + 2.0 * stroke.rim_px);
  draw(stroke.colour, stroke.width_px);
}

void Canvas::disc(cv::Point2d centre, double radius_px, const cv::Scalar& colour) {
  if (!is_near(centre)) return;
  const int radius = whole(radius_px * scale_ * (1 << kShift));
  cv::circle(picture_, fixed(centre), radius, colour, cv::FILLED, cv::LINE_AA, kShift);
}

void Canvas::polygon(const std::vector<cv::Point2d>& corners, const cv::Scalar& colour) {
  std::vector<cv::Point> points;
  for (const cv::Point2d corner : corners) {
    if (!is_near(corner)) return;
    points.push_back(fixed(corner));
  }
  cv::fillConvexPoly(picture_, points, colour, cv::LINE_AA, kShift);
}

void Canvas::rectangle(const cv::Rect2d& rect, const cv::Scalar& colour) {
  const cv::Rect inside = cv::Rect(rect) & cv::Rect({}, picture_.size());
  if (!inside.empty()) picture_(inside).setTo(colour);
}

void Canvas::text(cv::Point2d left_foot, const std::string& text, double height_px, const Stroke& stroke) {
  const double font_scale = height_px * scale_ / kFontHeight_px;
  const auto draw = [&](const cv::Scalar& colour, double width_px) {
    cv::putText(picture_, text, cv::Point(left_foot), kFont, font_scale, colour, whole(width_px * scale_),
                cv::LINE_AA);
  };
  if (stroke.rim_px > 0.0) draw(stroke.rim, stroke.width_px + 2.0 * stroke.rim_px);
  draw(stroke.colour, stroke.width_px);
}

double Canvas::width_of(const std::string& text, double height_px) const {
  return cv::getTextSize(text, kFont, height_px * scale_ / kFontHeight_px, 1, nullptr).width;
}

}  // namespace lineservo::apps
