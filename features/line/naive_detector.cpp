#include "features/line/naive_detector.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "features/geometry/angles.h"
#include "features/line/hough_lines.h"
#include "features/line/level_line.h"
#include "features/line/scene_check.h"

namespace lineservo::features {
namespace {

constexpr double kLeastVotes = 0.35;  // of the image's short side,
constexpr int kMostVotes = 150;       // but not more: a bin of Hough's holds no more of a slanted line

cv::Mat edges_of(const cv::Mat& image) {
  cv::Mat grey = image, edges;
  if (image.channels() == 3) cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  cv::Canny(grey, edges, 50.0, 150.0);
  return edges;
}

// What Hough's bins of 1 px by 1° round off.
Eigen::Matrix2d bin_covariance() {
  return Eigen::Vector2d(1.0, radians(1.0) * radians(1.0)).asDiagonal() * (1.0 / 12.0);
}

DetectedLine completed(const VotedLine& voted, const LineScene& scene) {
  DetectedLine detected{voted.line, std::nullopt};
  ImageLine& line = detected.image;
  const auto stretch = stretch_in_image(line, scene.image.size()).value_or(std::pair{0.0, 1.0});
  line.begin = line.at(stretch.first);
  line.end = line.at(stretch.second);
  line.quality = std::min(1.0, voted.votes / std::max(1.0, stretch.second - stretch.first));
  line.covariance = bin_covariance();
  if (scene.camera) detected.level = level_line(line, *scene.camera);
  return detected;
}

}  // namespace

std::vector<DetectedLine> NaiveDetector::detect(const LineScene& scene) {
  require_image(scene.image);
  if (!is_large_enough(scene.image)) return {};
  const double share = kLeastVotes * std::min(scene.image.cols, scene.image.rows);
  const int least_votes = std::clamp(static_cast<int>(share), 8, kMostVotes);
  const std::vector<VotedLine> lines = hough_lines(edges_of(scene.image), least_votes);
  const auto best_of = [&lines](bool up) {
    return std::find_if(lines.begin(), lines.end(),
                        [up](const VotedLine& voted) { return runs_up(voted.line) == up; });
  };
  const auto votes_of = [&](bool up) { return best_of(up) == lines.end() ? 0.0 : best_of(up)->votes; };
  const bool up_first = up_comes_first(votes_of(true), votes_of(false));
  std::vector<DetectedLine> detected;
  for (const bool up : {up_first, !up_first})
    if (best_of(up) != lines.end()) detected.push_back(completed(*best_of(up), scene));
  return detected;
}

}  // namespace lineservo::features
