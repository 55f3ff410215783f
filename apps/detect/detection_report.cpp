#include "apps/detect/detection_report.h"

#include <fmt/format.h>

#include "features/geometry/angles.h"

namespace lineservo::apps {
namespace {

using nlohmann::ordered_json;

ordered_json to_json(const features::ImageLine& line) {
  return {{"rho_px", line.rho_px},     {"theta_deg", features::degrees(line.theta_rad)},
          {"x1", line.begin.x},        {"y1", line.begin.y},
          {"x2", line.end.x},          {"y2", line.end.y},
          {"width_px", line.width_px}, {"quality", line.quality}};
}

ordered_json to_json(const std::optional<features::PixelPoint>& point) {
  if (!point) return nullptr;
  return {{"x_px", point->x}, {"y_px", point->y}};
}

ordered_json lines_json(const std::vector<features::ImageLine>& lines) {
  ordered_json list = ordered_json::array();
  for (const features::ImageLine& line : lines) list.push_back(to_json(line));
  return list;
}

std::string color_text(const features::ImageDetection& seen) {
  return seen.color ? fmt::format("{} ({:.0f} % sure)", features::name(*seen.color), 100.0 * seen.evidence)
                    : "no line";
}

}  // namespace

ordered_json to_json(const DetectionReport& report) {
  if (report.error) return {{"image", report.image}, {"error", *report.error}};
  const features::ImageDetection& seen = report.detection;
  ordered_json json;
  json["image"] = report.image;
  json["width"] = report.width_px;
  json["height"] = report.height_px;
  json["method"] = report.method;
  json["color"] = seen.color ? ordered_json(features::name(*seen.color)) : ordered_json(nullptr);
  json["confidence"] = seen.evidence;
  json["line"] = seen.lines.empty() ? ordered_json(nullptr) : to_json(seen.lines.front());
  json["lines"] = lines_json(seen.lines);
  json["centroid"] = to_json(seen.centroid_px);
  json["junction"] = features::name(seen.code);
  json["junction_center"] = to_json(seen.junction_px);
  json["foreground_ratio"] = seen.foreground_ratio;
  json["perception_ms"] = report.perception_ms;
  return json;
}

std::string to_text(const DetectionReport& report) {
  if (report.error) return fmt::format("{}: error: {}\n", report.image, *report.error);
  const features::ImageDetection& seen = report.detection;
  std::string text =
      fmt::format("{}  {}x{}  {}  {}  {:.1f} ms\n", report.image, report.width_px, report.height_px,
                  color_text(seen), features::name(seen.code), report.perception_ms);
  if (!seen.lines.empty())
    text += fmt::format("  {:>9} {:>10} {:>17} {:>17} {:>9} {:>8}\n", "rho (px)", "theta (deg)", "from (px)",
                        "to (px)", "width", "quality");
  for (const features::ImageLine& line : seen.lines)
    text += fmt::format("  {:>9.1f} {:>10.2f}  {:>8.1f},{:>7.1f}  {:>8.1f},{:>7.1f} {:>9.1f} {:>8.2f}\n",
                        line.rho_px, features::degrees(line.theta_rad), line.begin.x, line.begin.y,
                        line.end.x, line.end.y, line.width_px, line.quality);
  return text;
}

}  // namespace lineservo::apps
