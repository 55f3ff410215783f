#include "apps/view/view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <deque>
#include <map>

namespace lineservo::apps {
namespace {

/// What the user does and sees, and the clock on the wall.
struct Desk {
  double now_s = 0.0;
  std::multimap<double, ViewKey> keys;    ///< when they are pressed
  std::vector<double> pictures, samples;  ///< times of what is shown
  WindowState state = WindowState::open;
  double quits_s = 1e9;  ///< when Ctrl-C is pressed
};

class DeskWindow final : public ViewWindow {
 public:
  explicit DeskWindow(Desk& desk) : desk_(desk) {}
  void show(const cv::Mat& picture) override { desk_.pictures.push_back(picture.at<double>(0)); }
  void plot(const PlotSample& sample) override { desk_.samples.push_back(sample.time_s); }
  std::optional<ViewKey> key() override {
    if (desk_.keys.empty() || desk_.keys.begin()->first > desk_.now_s) return std::nullopt;
    const ViewKey key = desk_.keys.begin()->second;
    desk_.keys.erase(desk_.keys.begin());
    return key;
  }
  WindowState state() const override { return desk_.state; }

 private:
  Desk& desk_;
};

class ViewTest : public ::testing::Test {
 protected:
  View view(ViewPace pace = ViewPace::real_time) {
    return {std::make_unique<DeskWindow>(desk_),
            pace,
            [this] { return desk_.now_s < desk_.quits_s; },
            {[this] { return desk_.now_s; }, [this](double seconds) { desk_.now_s += seconds; }}};
  }
  /// Shows a tick, whose making takes so long; returns the wall's time afterwards.
  double show(View& view, double time_s, double making_s = 0.0) {
    desk_.now_s += making_s;
    cv::Mat picture(1, 1, CV_64F, cv::Scalar(time_s));
    view.show(time_s, [&]() -> const cv::Mat& { return picture; }, {time_s, {}, {}});
    return desk_.now_s;
  }

  Desk desk_;
};

TEST_F(ViewTest, HoldsTicksBackToRealTime) {
  View v = view();
  desk_.now_s = 100.0;
  EXPECT_NEAR(show(v, 7.0), 100.0, 0.011);
  EXPECT_NEAR(show(v, 7.1), 100.1, 0.011);
  EXPECT_NEAR(show(v, 9.0, 0.5), 102.0, 0.011);
  EXPECT_THAT(desk_.pictures, ::testing::ElementsAre(7.0, 7.1, 9.0));
  EXPECT_THAT(desk_.samples, ::testing::ElementsAre(7.0, 7.1, 9.0));
}

TEST_F(ViewTest, DoesNotRaceAfterTicksThatCameTooLate) {
  View v = view();
  show(v, 0.0);
  EXPECT_NEAR(show(v, 0.1, 5.0), 5.0, 0.02);
  EXPECT_NEAR(show(v, 0.2), 5.1, 0.03);
}

TEST_F(ViewTest, FastItHoldsNothingBackAndShowsWhatTheEyeCanFollow) {
  View v = view(ViewPace::fast);
  for (int k = 0; k < 100; ++k) show(v, 0.1 * k, 0.005);
  EXPECT_NEAR(desk_.now_s, 0.5, 1e-9);
  EXPECT_GT(desk_.pictures.size(), 9u);
  EXPECT_LT(desk_.pictures.size(), 16u);
}

TEST_F(ViewTest, FGoesFastAndBackToRealTime) {
  View v = view();
  desk_.keys = {{1.0, ViewKey::fast}};
  show(v, 0.0);
  EXPECT_NEAR(show(v, 50.0), 1.0, 0.02);
  EXPECT_NEAR(show(v, 100.0), 1.0, 0.02);
  desk_.keys = {{0.0, ViewKey::fast}};
  show(v, 100.1);
  EXPECT_NEAR(show(v, 100.6), 1.5, 0.05);
}

TEST_F(ViewTest, SpacePausesAndGoesOnFromThere) {
  View v = view();
  desk_.keys = {{0.5, ViewKey::pause}, {30.0, ViewKey::pause}};
  show(v, 0.0);
  EXPECT_NEAR(show(v, 1.0), 30.0, 0.02);
  EXPECT_NEAR(show(v, 1.5), 30.5, 0.03);
}

TEST_F(ViewTest, NPausesAndThenLetsOneTickThroughAtATime) {
  View v = view();
  desk_.keys = {{0.0, ViewKey::step}, {10.0, ViewKey::step}, {20.0, ViewKey::step}, {30.0, ViewKey::pause}};
  EXPECT_NEAR(show(v, 0.0), 10.0, 0.02);
  EXPECT_NEAR(show(v, 0.1), 20.0, 0.02);
  EXPECT_NEAR(show(v, 0.2), 30.0, 0.02);
  EXPECT_NEAR(show(v, 0.3), 30.1, 0.03) << "and runs again";
  EXPECT_EQ(desk_.pictures.size(), 4u);
}

TEST_F(ViewTest, APauseOfAFastViewReturnsToFast) {
  View v = view(ViewPace::fast);
  desk_.keys = {{0.0, ViewKey::pause}, {2.0, ViewKey::pause}};
  show(v, 0.0);
  EXPECT_NEAR(show(v, 100.0), 2.0, 0.02);
}

TEST_F(ViewTest, QuitEndsAtOnceAndShowsNothingMore) {
  View v = view();
  desk_.keys = {{0.2, ViewKey::quit}};
  show(v, 0.0);
  EXPECT_FALSE(v.wants_end());
  EXPECT_NEAR(show(v, 9.0), 0.2, 0.02);
  EXPECT_TRUE(v.wants_end());
  EXPECT_NEAR(show(v, 99.0), 0.2, 0.02);
  EXPECT_EQ(desk_.pictures.size(), 2u);
  EXPECT_EQ(v.take_news(), std::nullopt);
}

TEST_F(ViewTest, AnInterruptEndsAPause) {
  View v = view(ViewPace::paused);
  desk_.quits_s = 3.0;
  EXPECT_NEAR(show(v, 0.0), 3.0, 0.02);
}

TEST_F(ViewTest, AWindowThatTheUserClosedEndsAsQuitDoes) {
  View v = view(ViewPace::paused);
  desk_.state = WindowState::closed;
  show(v, 0.0);
  EXPECT_TRUE(v.wants_end());
}

TEST_F(ViewTest, WithoutItsDisplayEverythingGoesOnAndItIsSaidOnce) {
  View v = view();
  show(v, 0.0);
  desk_.state = WindowState::lost;
  EXPECT_LT(show(v, 50.0), 0.1);
  EXPECT_LT(show(v, 99.0), 0.1);
  EXPECT_FALSE(v.wants_end());
  EXPECT_THAT(v.take_news().value_or(""), ::testing::HasSubstr("display is gone"));
  EXPECT_EQ(v.take_news(), std::nullopt);
}

}  // namespace
}  // namespace lineservo::apps
