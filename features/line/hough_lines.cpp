#include "features/line/hough_lines.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "features/geometry/angles.h"

namespace lineservo::features {
namespace {

constexpr std::size_t kMostLines = 500;
constexpr std::ptrdiff_t kPerTopic = 2;

struct Cluster {
  ImageLine mean;
  double votes = 0.0;  // of all its lines
  double top = 0.0;    // of its best line
};

void join(Cluster& cluster, const VotedLine& voted) {
  const LineDifference d = difference(voted.line, cluster.mean);
  cluster.votes += voted.votes;
  const double share = voted.votes / cluster.votes;
  cluster.mean =
      canonical_line(cluster.mean.rho_px + share * d.rho_px, cluster.mean.theta_rad + share * d.theta_rad);
}

Cluster* nearest(std::vector<Cluster>& clusters, const ImageLine& line, const ClusterReach& reach) {
  Cluster* best = nullptr;
  double least = 1.0;
  for (Cluster& cluster : clusters) {
    if (runs_up(cluster.mean) != runs_up(line)) continue;
    const LineDifference d = difference(line, cluster.mean);
    const double apart = std::max(std::abs(d.rho_px) / reach.rho_px, std::abs(d.theta_rad) / reach.theta_rad);
    if (apart > least) continue;
    least = apart;
    best = &cluster;
  }
  return best;
}

double most_votes(const std::vector<Cluster>& clusters, bool up) {
  double most = 0.0;
  for (const Cluster& cluster : clusters)
    if (runs_up(cluster.mean) == up) most = std::max(most, cluster.top);
  return most;
}

}  // namespace

std::vector<VotedLine> hough_lines(const cv::Mat& binary, int least_votes) {
  std::vector<cv::Vec3f> found;
  cv::HoughLines(binary, found, 1.0, CV_PI / 180.0, least_votes);
  if (found.size() > kMostLines) found.resize(kMostLines);
  std::vector<VotedLine> lines;
  lines.reserve(found.size());
  for (const cv::Vec3f& line : found)
    lines.push_back({canonical_line(line[0], static_cast<double>(line[1])), line[2]});
  return lines;
}

std::vector<ImageLine> cluster_lines(const std::vector<VotedLine>& lines, const ClusterReach& reach) {
  std::vector<Cluster> clusters;
  for (const VotedLine& voted : lines) {
    if (Cluster* cluster = nearest(clusters, voted.line, reach))
      join(*cluster, voted);
    else
      clusters.push_back({voted.line, voted.votes, voted.votes});
  }
  const bool up_first = up_comes_first(most_votes(clusters, true), most_votes(clusters, false));
  std::stable_sort(clusters.begin(), clusters.end(), [up_first](const Cluster& a, const Cluster& b) {
    if (runs_up(a.mean) != runs_up(b.mean)) return runs_up(a.mean) == up_first;
    return a.top > b.top;
  });
  std::vector<ImageLine> means;
  for (const Cluster& cluster : clusters) {
    const auto of_topic = std::count_if(means.begin(), means.end(), [&cluster](const ImageLine& line) {
      return runs_up(line) == runs_up(cluster.mean);
    });
    if (of_topic < kPerTopic) means.push_back(cluster.mean);
  }
  return means;
}

}  // namespace lineservo::features
