#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

namespace lineservo::apps {

/// One line of a track's skeleton, between two nodes, in pixels.
struct TrackEdge {
  int from = 0, to = 0;             ///< nodes
  std::vector<cv::Point2d> points;  ///< from node to node, both included
  double width_px = 0.0;            ///< median
};

/// What was traced: places where lines end, meet or turn sharply, and the lines between them.
struct TrackGraph {
  std::vector<cv::Point2d> nodes;
  std::vector<TrackEdge> edges;
};

/// Traces the lines of a mask (CV_8UC1, painted where not zero): its skeleton, cut where lines meet, without
/// the spurs that thinning leaves, with the ends carried on to where the paint ends, and cut again where a
/// line turns by more than 20° within a width. Empty when the mask is.
TrackGraph trace_track(const cv::Mat& mask);

}  // namespace lineservo::apps
