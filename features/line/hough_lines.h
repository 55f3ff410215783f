#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "features/line/image_line.h"

namespace lineservo::features {

/// A line with the pixels that voted for it.
struct VotedLine {
  ImageLine line;
  double votes = 0.0;
};

/// Hough transform of a binary image, 1 px by 1°, most votes first; at least `least_votes` each. Of very many
/// the best 500.
std::vector<VotedLine> hough_lines(const cv::Mat& binary, int least_votes);

/// The two topics of grid §IV-B2: lines that run up the image, |θ| ≤ 45°, and lines that run across it.
inline bool runs_up(const ImageLine& line) {
  return std::abs(line.theta_rad) <= 0.25 * 3.14159265358979323846;
}

/// Which topic comes first by the votes of its best line: up, unless it has less than a third of the other's.
inline bool up_comes_first(double up_votes, double across_votes) {
  return up_votes >= across_votes / 3.0;
}

/// How near lines must be to be one (grid §IV-B2, Fig. 8).
struct ClusterReach {
  double rho_px = 0.0;
  double theta_rad = 0.0;
};

/// Mean clustering in (ρ, θ) of each topic (grid §IV-B2, §V): a line joins the nearest cluster of its topic
/// within reach, and the cluster takes the mean, each line by its votes. Those that run up come first unless
/// the best of them has less than a third of the votes of the best that runs across: then it is a fork at the
/// end of a skeleton. Of each topic the one with most votes comes first, and at most two of each are given.
std::vector<ImageLine> cluster_lines(const std::vector<VotedLine>& lines, const ClusterReach& reach);

}  // namespace lineservo::features
