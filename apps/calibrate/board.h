#pragma once

#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

namespace lineservo::apps {

/// A chessboard, told by the corners at which four squares meet.
struct Board {
  int columns = 9, rows = 6;
  double square_m = 0.025;
};

/// The board of "9x6", inner corners. Throws InputError unless both are whole numbers from 3 to 100.
Board read_board(const std::string& columns_by_rows, double square_m);

/// All inner corners, row by row, in pixels (the centre of the top-left one is 0, 0), or none. `image`:
/// CV_8UC1 or CV_8UC3.
std::optional<std::vector<cv::Point2f>> find_board(const cv::Mat& image, const Board& board);

/// The same corners on the board, in metres, z = 0.
std::vector<cv::Point3f> board_corners_m(const Board& board);

}  // namespace lineservo::apps
