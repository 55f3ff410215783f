#include "apps/calibrate/board.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/apps/test_files.h"
#include "tests/support/chess_boards.h"

namespace lineservo::apps {
namespace {

using ::testing::HasSubstr;

TEST(Board, IsColumnsByRows) {
  const Board board = read_board("9x6", 0.03);
  EXPECT_EQ(board.columns, 9);
  EXPECT_EQ(board.rows, 6);
  EXPECT_EQ(board.square_m, 0.03);
  for (const char* const bad : {"", "9", "9x", "x6", "9x6x3", "2x6", "9x101", "-9x6", "9 x 6"})
    EXPECT_THAT(testing::complaint([&] { read_board(bad, 0.03); }),
                HasSubstr("must be inner corners as 9x6"));
}

// A board square on: corner (i, j) lies at c + f (i − 4, j − 2.5) 0.025 / 0.4.
TEST(Board, CornersLieWhereTheBoardWasDrawn) {
  const support::ChessBoards boards({}, 9, 6, 0.025);
  const auto corners = find_board(boards.render({0, 0, 0}, {0, 0, 0.4}), {});
  ASSERT_TRUE(corners);
  ASSERT_EQ(corners->size(), 54u);
  const bool turned = corners->front().x > corners->back().x;  // the search may begin at either end
  for (int k = 0; k < 54; ++k) {
    const cv::Point2f& corner = (*corners)[static_cast<std::size_t>(turned ? 53 - k : k)];
    EXPECT_NEAR(corner.x, 319.5 + 320.0 * (k % 9 - 4.0) * 0.025 / 0.4, 0.1) << k;
    EXPECT_NEAR(corner.y, 239.5 + 320.0 * (k / 9 - 2.5) * 0.025 / 0.4, 0.1) << k;
  }
}

TEST(Board, NoneInABlankImageOrOneOfAnotherSize) {
  EXPECT_FALSE(find_board(cv::Mat(480, 640, CV_8UC3, cv::Scalar(120, 120, 120)), {}));
  const support::ChessBoards small({}, 5, 4, 0.025);
  EXPECT_FALSE(find_board(small.render({0, 0, 0}, {0, 0, 0.4}), {}));
}

}  // namespace
}  // namespace lineservo::apps
