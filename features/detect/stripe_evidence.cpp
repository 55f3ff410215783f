#include "features/detect/stripe_evidence.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace lineservo::features {
namespace {

constexpr double kLeastShare = 0.002;  // of the image that is paint
constexpr double kLongEnough = 0.5;    // of the image's shorter side
constexpr double kSlender = 2.0;       // length over width
constexpr double kBeside = 0.02;    // of the image's shorter side, from a border, where contrast is looked at
constexpr double kNoStep = 0.15;    // of the full contrast: so soft is no border
constexpr double kFullStep = 0.6;   // so sharp is sharp enough
constexpr double kCredible = 0.2;   // quality times sharpness of a line worth telling
constexpr double kOneBorder = 0.7;  // what a line counts whose other border is out of view: any edge has one
constexpr double kUnexplained = 0.35;  // what is left of a mask of which the lines explain nothing
constexpr double kOthers = 0.2;        // weight of the lines besides the best
constexpr int kSections = 24;
constexpr int kGrid_px = 4;

double shorter_side(const MaskGeometry& geometry) {
  const Eigen::Matrix3d& K = geometry.pinhole();
  return std::min(geometry.width_px() / K(0, 0), geometry.height_px() / K(1, 1));
}

std::optional<double> contrast_at(const cv::Mat& contrast, const MaskGeometry& geometry,
                                  const Eigen::Vector2d& p_L) {
  const PixelPoint px = geometry.project({p_L.x(), p_L.y()});
  const int x = static_cast<int>(std::lround(px.x)), y = static_cast<int>(std::lround(px.y));
  if (x < 0 || y < 0 || x >= contrast.cols || y >= contrast.rows) return std::nullopt;
  return contrast.at<std::uint8_t>(y, x);
}

/// Mean step of the contrast over one border (side −1 or 1), from outside to inside; none out of view.
std::optional<double> border_step(const WedgeLine& line, double side, const cv::Mat& contrast,
                                  const MaskGeometry& geometry) {
  const StripeAxes axes(line.wedge.course);
  const double beside = kBeside * shorter_side(geometry);
  double sum = 0.0;
  int steps = 0;
  for (int k = 0; k < kSections; ++k) {
    const double along = line.begin + line.length() * (k + 0.5) / kSections;
    const double half = 0.5 * line.width_at(along);
    const auto inside = contrast_at(contrast, geometry, axes.at(along, side * std::max(0.0, half - beside)));
    const auto outside = contrast_at(contrast, geometry, axes.at(along, side * (half + beside)));
    if (!inside || !outside) continue;
    sum += *inside - *outside;
    ++steps;
  }
  return steps == 0 ? std::nullopt : std::optional(sum / steps);
}

/// The view cuts it at both ends, so that nobody knows how long it is.
bool crosses_view(const WedgeLine& line, const PaintContrast& paint, const MaskGeometry& geometry) {
  const StripeAxes axes(line.wedge.course);
  const double beyond = 0.05 * shorter_side(geometry);
  return !contrast_at(paint.contrast, geometry, axes.at(line.begin - beyond, 0.0)) &&
         !contrast_at(paint.contrast, geometry, axes.at(line.end + beyond, 0.0));
}

bool shows_both_borders(const WedgeLine& line, const PaintContrast& paint, const MaskGeometry& geometry) {
  return border_step(line, -1.0, paint.contrast, geometry) &&
         border_step(line, 1.0, paint.contrast, geometry);
}

bool is_credible(const WedgeLine& line, const PaintContrast& paint, const MaskGeometry& geometry) {
  const double image_width = geometry.width_px() / geometry.pinhole()(0, 0);
  return line.wedge.course.width >= paint.least_width * image_width &&
         line.quality * sharpness(line, paint, geometry) >= kCredible;
}

double evidence_of(const std::vector<WedgeLine>& lines) {
  double best = 0.0, sum = 0.0;
  for (const WedgeLine& line : lines) {
    best = std::max(best, line.evidence);
    sum += line.evidence;
  }
  return std::min(1.0, best + kOthers * (sum - best));
}

}  // namespace

double sharpness(const WedgeLine& line, const PaintContrast& paint, const MaskGeometry& geometry) {
  const auto left = border_step(line, -1.0, paint.contrast, geometry);
  const auto right = border_step(line, 1.0, paint.contrast, geometry);
  if (!left && !right) return 0.0;
  const double softer = left && right ? std::min(*left, *right) : left ? *left : *right;
  return std::clamp((softer / paint.full - kNoStep) / (kFullStep - kNoStep), 0.0, 1.0);
}

double line_evidence(const WedgeLine& line, const PaintContrast& paint, const MaskGeometry& geometry) {
  const double longness = line.length() / (kLongEnough * shorter_side(geometry));
  const double slenderness =
      crosses_view(line, paint, geometry) ? 1.0 : line.length() / (kSlender * line.wedge.course.width);
  const double borders = shows_both_borders(line, paint, geometry) ? 1.0 : kOneBorder;
  return line.quality * std::min(1.0, longness) * std::min(1.0, slenderness) * borders *
         sharpness(line, paint, geometry);
}

double explained_share(const PackedMask& mask, const std::vector<WedgeLine>& lines,
                       const MaskGeometry& geometry) {
  const double margin = 0.005 * shorter_side(geometry);
  int painted = 0, explained = 0;
  for (int y = 0; y < mask.height(); y += kGrid_px) {
    for (int x = 0; x < mask.width(); x += kGrid_px) {
      if (!mask.at(x, y)) continue;
      const NormalizedPoint p = geometry.normalize({static_cast<double>(x), static_cast<double>(y)});
      ++painted;
      explained += int{std::any_of(lines.begin(), lines.end(), [&](const WedgeLine& line) {
        return line.covers({p.x, p.y}, margin);
      })};
    }
  }
  return painted == 0 ? 0.0 : static_cast<double>(explained) / painted;
}

double judge(const PackedMask& mask, const PaintContrast& paint, const MaskGeometry& geometry,
             WedgeLines& seen) {
  std::erase_if(seen.lines, [&](const WedgeLine& line) { return !is_credible(line, paint, geometry); });
  for (WedgeLine& line : seen.lines) line.evidence = line_evidence(line, paint, geometry);
  const double share = static_cast<double>(mask.count()) / (mask.width() * mask.height());
  if (share < kLeastShare || share > paint.largest_share) return 0.0;
  return evidence_of(seen.lines) *
         (kUnexplained + (1.0 - kUnexplained) * explained_share(mask, seen.lines, geometry));
}

}  // namespace lineservo::features
