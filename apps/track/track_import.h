#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <string>

#include "apps/track/track_graph.h"

namespace lineservo::apps {

/// How a bitmap of lines becomes a layout.
struct TrackImportOptions {
  std::string name;               ///< of the layout
  double metres_per_pixel = 0.0;  ///< 1e-4 … 1
  std::string start;              ///< a node's name; empty: the dead end that is furthest to the left
  double start_disc_m = 0.0;      ///< radius of the red disc on the start; 0: none
  std::string bitmap;             ///< the image beside the layout that is the floor; empty: lines are painted
};

/// What an image shows.
struct TrackImage {
  cv::Mat mask;                   ///< CV_8UC1, painted where not zero
  cv::Vec3b floor_bgr, line_bgr;  ///< the most frequent colour, and the middle one of what differs from it
};

/// Tells paint from floor: the floor is the most frequent colour, paint is what differs from it (Otsu's
/// threshold on the distance). Throws InputError behind `where` when nothing does, or most of the image.
TrackImage paint_of_image(const cv::Mat& image, const std::string& where);

/// The layout of a bitmap track as YAML: x to the right and y up from the middle of the image's lower left
/// pixel, nodes n0, n1, … from left to right. Throws InputError behind `where` when no line is found or the
/// start is no node.
std::string layout_of_track(const TrackImage& image, const TrackImportOptions& options,
                            const std::string& where);

}  // namespace lineservo::apps
