#include "apps/track/track_import.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "apps/config/input_error.h"

namespace lineservo::apps {
namespace {

constexpr double kLeastContrast = 30.0;  // of 441 between black and white
constexpr double kMostPainted = 0.6;
constexpr int kLeastPatch_px = 30;  // smaller is dirt

using Channels = std::array<int, 3>;

cv::Mat in_colour(const cv::Mat& image) {
  if (image.channels() == 3) return image;
  cv::Mat bgr;
  cv::cvtColor(image, bgr, cv::COLOR_GRAY2BGR);
  return bgr;
}

/// The mean of the fullest of 16³ bins.
cv::Vec3b most_frequent(const cv::Mat& bgr) {
  std::map<int, std::pair<long, Channels>> bins;
  for (int y = 0; y < bgr.rows; ++y) {
    for (int x = 0; x < bgr.cols; ++x) {
      const cv::Vec3b& p = bgr.at<cv::Vec3b>(y, x);
      auto& [count, sum] = bins[(p[0] / 16 * 16 + p[1] / 16) * 16 + p[2] / 16];
      if (count > 1000000) continue;  // the sums stay in range
      ++count;
      for (int c = 0; c < 3; ++c) sum[static_cast<std::size_t>(c)] += p[c];
    }
  }
  const auto fullest = std::max_element(
      bins.begin(), bins.end(), [](const auto& a, const auto& b) { return a.second.first < b.second.first; });
  const auto& [count, sum] = fullest->second;
  const auto mean = [&, n = count](std::size_t c) { return static_cast<std::uint8_t>(sum[c] / n); };
  return {mean(0), mean(1), mean(2)};
}

/// The distance of each pixel from a colour, half of it so that it fits into a byte.
cv::Mat distance_from(const cv::Mat& bgr, const cv::Vec3b& colour) {
  cv::Mat distance(bgr.size(), CV_8U);
  for (int y = 0; y < bgr.rows; ++y) {
    for (int x = 0; x < bgr.cols; ++x) {
      const cv::Vec3b& p = bgr.at<cv::Vec3b>(y, x);
      const double d = std::hypot(p[0] - colour[0], p[1] - colour[1], p[2] - colour[2]);
      distance.at<std::uint8_t>(y, x) = static_cast<std::uint8_t>(0.5 * d);
    }
  }
  return distance;
}

void drop_dirt(cv::Mat& mask) {
  cv::Mat labels, statistics, centres;
  cv::connectedComponentsWithStats(mask, labels, statistics, centres, 8, CV_32S);
  for (int y = 0; y < mask.rows; ++y)
    for (int x = 0; x < mask.cols; ++x)
      if (statistics.at<int>(labels.at<int>(y, x), cv::CC_STAT_AREA) < kLeastPatch_px)
        mask.at<std::uint8_t>(y, x) = 0;
}

std::uint8_t middle(std::vector<std::uint8_t>& levels) {
  std::nth_element(levels.begin(), levels.begin() + std::ssize(levels) / 2, levels.end());
  return levels[levels.size() / 2];
}

cv::Vec3b middle_colour(const cv::Mat& bgr, const cv::Mat& mask) {
  std::array<std::vector<std::uint8_t>, 3> levels;
  for (int y = 0; y < bgr.rows; ++y)
    for (int x = 0; x < bgr.cols; ++x)
      for (std::size_t c = 0; c < 3 && mask.at<std::uint8_t>(y, x) != 0; ++c)
        levels[c].push_back(bgr.at<cv::Vec3b>(y, x)[static_cast<int>(c)]);
  return {middle(levels[0]), middle(levels[1]), middle(levels[2])};
}

/// A traced track in metres, its nodes named from left to right.
class TrackWriter {
 public:
  TrackWriter(const TrackImage& image, const TrackImportOptions& options, const std::string& where)
      : image_(image), options_(options), where_(where), graph_(trace_track(image.mask)) {
    if (graph_.edges.empty()) throw InputError(where + ": no line was found in it");
    std::vector<std::size_t> order(graph_.nodes.size());
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
    std::sort(order.begin(), order.end(), [this](std::size_t a, std::size_t b) {
      return std::pair(graph_.nodes[a].x, -graph_.nodes[a].y) <
             std::pair(graph_.nodes[b].x, -graph_.nodes[b].y);
    });
    names_.resize(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) names_[order[k]] = fmt::format("n{}", k);
  }

  std::string text() const {
    std::string yaml = fmt::format(
        "name: {}\ndescription: traced from a bitmap of {}×{} px at {} m a pixel\n"
        "floor: {{colour: {}}}\n{}line: {{colour: {}}}\nnodes:\n",
        options_.name, image_.mask.cols, image_.mask.rows, options_.metres_per_pixel, rgb(image_.floor_bgr),
        bitmap(), rgb(image_.line_bgr));
    for (const std::size_t k : by_name()) {
      const cv::Point2d p = metres(graph_.nodes[k]);
      yaml += fmt::format("  - {{name: {}, x_m: {:.4f}, y_m: {:.4f}}}\n", names_[k], p.x, p.y);
    }
    yaml += "edges:\n";
    for (const TrackEdge& edge : graph_.edges) yaml += edge_text(edge);
    return yaml + fmt::format("start: {{node: {}{}}}\n", start(), disc());
  }

 private:
  static std::string rgb(const cv::Vec3b& bgr) { return fmt::format("[{}, {}, {}]", bgr[2], bgr[1], bgr[0]); }

  std::string bitmap() const {
    if (options_.bitmap.empty()) return {};
    return fmt::format("bitmap: {{file: \"{}\", metres_per_pixel: {}}}\n", options_.bitmap,
                       options_.metres_per_pixel);
  }

  std::string disc() const {
    return options_.start_disc_m > 0.0 ? fmt::format(", marker_radius_m: {}", options_.start_disc_m) : "";
  }

  cv::Point2d metres(const cv::Point2d& px) const {
    return options_.metres_per_pixel * cv::Point2d(px.x, image_.mask.rows - 1 - px.y);
  }

  std::vector<std::size_t> by_name() const {
    std::vector<std::size_t> order(names_.size());
    for (std::size_t k = 0; k < names_.size(); ++k)
      order[static_cast<std::size_t>(std::stoi(names_[k].substr(1)))] = k;
    return order;
  }

  std::string edge_text(const TrackEdge& edge) const {
    std::string text =
        fmt::format("  - {{from: {}, to: {}, width_m: {:.4f}", names_[static_cast<std::size_t>(edge.from)],
                    names_[static_cast<std::size_t>(edge.to)], edge.width_px * options_.metres_per_pixel);
    std::string through;
    for (const cv::Point2d& px : through_points(edge)) {
      const cv::Point2d p = metres(px);
      through += fmt::format("{}[{:.4f}, {:.4f}]", through.empty() ? "" : ", ", p.x, p.y);
    }
    if (!through.empty()) text += ", through: [" + through + "]";
    return text + "}\n";
  }

  /// None for a straight line, else a point every width or so.
  static std::vector<cv::Point2d> through_points(const TrackEdge& edge) {
    const auto& p = edge.points;
    const cv::Point2d d = p.back() - p.front();
    double off_px = 0.0;
    for (const cv::Point2d& q : p) {
      const cv::Point2d r = q - p.front();
      off_px = std::max(off_px, std::abs(d.x * r.y - d.y * r.x) / std::max(1.0, cv::norm(d)));
    }
    if (edge.from != edge.to && off_px < std::max(1.5, 0.1 * edge.width_px)) return {};
    const double step_px = std::max(8.0, edge.width_px);
    std::vector<cv::Point2d> points;
    cv::Point2d last = p.front();
    for (const cv::Point2d& q : p) {
      if (cv::norm(q - last) < step_px || cv::norm(q - p.back()) < 0.7 * step_px) continue;
      points.push_back(q);
      last = q;
    }
    return points;
  }

  std::string start() const {
    if (!options_.start.empty()) {
      if (std::find(names_.begin(), names_.end(), options_.start) != names_.end()) return options_.start;
      throw InputError(fmt::format("--start {}: there is no such node; there are n0 to n{}", options_.start,
                                   names_.size() - 1));
    }
    const auto is_end = [this](std::size_t k) {
      return std::count_if(graph_.edges.begin(), graph_.edges.end(), [k](const TrackEdge& e) {
               return (e.from == static_cast<int>(k)) != (e.to == static_cast<int>(k));
             }) == 1;
    };
    for (const std::size_t k : by_name())
      if (is_end(k)) return names_[k];
    return "n0";
  }

  const TrackImage& image_;
  const TrackImportOptions& options_;
  const std::string& where_;
  TrackGraph graph_;
  std::vector<std::string> names_;
};

}  // namespace

TrackImage paint_of_image(const cv::Mat& image, const std::string& where) {
  const cv::Mat bgr = in_colour(image);
  TrackImage track;
  track.floor_bgr = most_frequent(bgr);
  const cv::Mat distance = distance_from(bgr, track.floor_bgr);
  cv::threshold(distance, track.mask, 0, 255, cv::THRESH_BINARY | cv::THRESH_OTSU);
  double farthest = 0.0;
  cv::minMaxLoc(distance, nullptr, &farthest);
  if (2.0 * farthest < kLeastContrast)
    throw InputError(where + ": no line differs from the floor, its most frequent colour");
  drop_dirt(track.mask);
  const int painted = cv::countNonZero(track.mask);
  if (painted == 0) throw InputError(where + ": no line was found in it");
  if (painted > kMostPainted * static_cast<double>(track.mask.total()))
    throw InputError(where +
                     ": most of it differs from its most frequent colour: lines must be fewer than floor");
  track.line_bgr = middle_colour(bgr, track.mask);
  return track;
}

std::string layout_of_track(const TrackImage& image, const TrackImportOptions& options,
                            const std::string& where) {
  return TrackWriter(image, options, where).text();
}

}  // namespace lineservo::apps
