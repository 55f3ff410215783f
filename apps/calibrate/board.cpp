#include "apps/calibrate/board.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "apps/config/input_error.h"
#include "apps/config/numbers.h"

namespace lineservo::apps {
namespace {

/// From a corner to the next of its row, the least of all.
double least_spacing_px(const std::vector<cv::Point2f>& corners, const Board& board) {
  double least = std::numeric_limits<double>::max();
  for (std::size_t k = 1; k < corners.size(); ++k)
    if (k % static_cast<std::size_t>(board.columns) != 0)
      least = std::min(least, cv::norm(corners[k] - corners[k - 1]));
  return least;
}

/// The search leaves them off by some 0.1 px. The window holds one corner alone.
void refine(const cv::Mat& grey, const Board& board, std::vector<cv::Point2f>& corners) {
  const int half = std::clamp(static_cast<int>(0.3 * least_spacing_px(corners, board)), 2, 10);
  cv::cornerSubPix(grey, corners, {half, half}, {-1, -1},
                   {cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 50, 1e-3});
}

}  // namespace

Board read_board(const std::string& columns_by_rows, double square_m) {
  const std::size_t by = std::min(columns_by_rows.find('x'), columns_by_rows.size());
  const auto columns = parse_number(columns_by_rows.substr(0, by), 3, 100);
  const auto rows = parse_number(columns_by_rows.substr(std::min(by + 1, columns_by_rows.size())), 3, 100);
  if (!columns || !rows)
    throw InputError(
        fmt::format("--board '{}': must be inner corners as 9x6, each from 3 to 100", columns_by_rows));
  return {*columns, *rows, square_m};
}

// The quick classic search, then the one that is more robust (OpenCV).
std::optional<std::vector<cv::Point2f>> find_board(const cv::Mat& image, const Board& board) {
  const cv::Size size(board.columns, board.rows);
  cv::Mat grey = image;
  if (image.channels() == 3) cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  std::vector<cv::Point2f> corners;
  if (!cv::findChessboardCorners(grey, size, corners) &&
      !cv::findChessboardCornersSB(grey, size, corners,
                                   cv::CALIB_CB_NORMALIZE_IMAGE | cv::CALIB_CB_EXHAUSTIVE))
    return std::nullopt;
  refine(grey, board, corners);
  return corners;
}

std::vector<cv::Point3f> board_corners_m(const Board& board) {
  std::vector<cv::Point3f> corners;
  for (int row = 0; row < board.rows; ++row)
    for (int column = 0; column < board.columns; ++column)
      corners.emplace_back(static_cast<float>(column * board.square_m),
                           static_cast<float>(row * board.square_m), 0.0F);
  return corners;
}

}  // namespace lineservo::apps
