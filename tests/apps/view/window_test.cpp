// The windows of --view on a display without a screen, by the module and by the program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>

#include "apps/overlay/ink.h"
#include "apps/view/load_window.h"
#include "tests/apps/cli/program_test.h"
// last: X11
#include "tests/support/virtual_display.h"

namespace lineservo::apps {
namespace {

namespace fs = std::filesystem;
using lineservo::testing::VirtualDisplay;
using ::testing::HasSubstr;
using testing::read_text;

constexpr const char* kTitle = "lineservo fly node:q";

/// Of a colour or one that is hardly another.
int pixels_of(const cv::Mat& picture, const cv::Scalar& colour) {
  const cv::Scalar off = cv::Scalar::all(30.0);
  cv::Mat same;
  cv::inRange(picture, colour - off, colour + off, same);
  return cv::countNonZero(same);
}

class WindowTest : public ProgramTest {
 protected:
  void SetUp() override {
    if (!display_.is_up()) GTEST_SKIP() << "there is no Xvfb (the package xvfb)";
  }
  Window program_window() const {
    const auto window = display_.window(kTitle);
    EXPECT_TRUE(window.has_value());
    return window.value_or(0);
  }
  /// The screenshot once it has so many pixels of a colour.
  cv::Mat shot_with(Window window, const cv::Scalar& colour, int least) const {
    cv::Mat shot;
    EXPECT_TRUE(VirtualDisplay::wait_for([&] {
      shot = display_.screenshot(window);
      return pixels_of(shot, colour) >= least;
    }));
    return shot;
  }
  static std::string hash_of(const Ran& ran) {
    return nlohmann::json::parse(ran.out)["trajectory_sha256"].get<std::string>();
  }

  VirtualDisplay display_;
};

TEST_F(WindowTest, ShowsThePictureAsItIs) {
  cv::Mat picture(200, 300, CV_8UC3, cv::Scalar(10, 100, 200));
  cv::rectangle(picture, {50, 60, 80, 40}, ink::kSky, cv::FILLED);
  std::string complaint;
  const auto window = load_window({"picture", picture.size()}, complaint);
  ASSERT_TRUE(window) << complaint;
  window->show(picture);
  const Window shown = *display_.window("picture");
  // The server draws when it comes to it.
  EXPECT_TRUE(VirtualDisplay::wait_for(
      [&] { return cv::norm(display_.screenshot(shown), picture, cv::NORM_INF) == 0.0; }));
  EXPECT_EQ(window->state(), WindowState::open);
}

TEST_F(WindowTest, HearsTheKeysThatCountInBothOfItsWindows) {
  std::string complaint;
  const auto window = load_window({"keys", {300, 200}}, complaint);
  ASSERT_TRUE(window) << complaint;
  EXPECT_EQ(window->key(), std::nullopt);
  const std::pair<KeySym, std::optional<ViewKey>> keys[] = {{XK_space, ViewKey::pause}, {XK_n, ViewKey::step},
                                                            {XK_f, ViewKey::fast},      {XK_q, ViewKey::quit},
                                                            {XK_Escape, ViewKey::quit}, {XK_x, std::nullopt}};
  for (const char* title : {"keys", "keys: features and velocities"}) {
    for (const auto& [pressed, heard] : keys) {
      display_.press(*display_.window(title), pressed);
      EXPECT_EQ(window->key(), heard) << title << " " << XKeysymToString(pressed);
    }
  }
  EXPECT_EQ(window->key(), std::nullopt);
}

TEST_F(WindowTest, PlotsFeaturesAndVelocitiesInTheirColours) {
  std::string complaint;
  const auto window = load_window({"plots", {300, 200}}, complaint);
  ASSERT_TRUE(window) << complaint;
  const Window plots = *display_.window("plots: features and velocities");
  const double absent = std::numeric_limits<double>::quiet_NaN();
  const auto plot = [&](double time_s) {
    window->plot({time_s, {0.5, -0.2, absent}, {0.1, 0.05, absent, 0.09, absent}});
  };
  plot(0.0);  // it draws the legend
  const int green_before = pixels_of(display_.screenshot(plots), ink::kGreen);
  for (int k = 1; k < 20; ++k) plot(0.5 * k);
  const cv::Mat shot = display_.screenshot(plots);
  EXPECT_GT(pixels_of(shot, ink::kBlue), 100);
  EXPECT_GT(pixels_of(shot, ink::kSky), 50);
  EXPECT_EQ(pixels_of(shot, ink::kGreen), green_before) << "what is absent is not plotted";
}

TEST_F(WindowTest, AClosedWindowAndAGoneDisplayAreToldApartAndSurvived) {
  std::string complaint;
  const cv::Mat picture(200, 300, CV_8UC3, cv::Scalar(1, 2, 3));
  const auto closed = load_window({"closed", picture.size()}, complaint);
  const auto lost = load_window({"lost", picture.size()}, complaint);
  ASSERT_TRUE(closed && lost) << complaint;
  display_.close(*display_.window("closed"));
  closed->show(picture);
  closed->show(picture);
  EXPECT_EQ(closed->key(), std::nullopt);
  EXPECT_EQ(closed->state(), WindowState::closed);
  EXPECT_EQ(lost->state(), WindowState::open);
  display_.crash();
  lost->show(picture);
  lost->plot({});
  EXPECT_EQ(lost->key(), std::nullopt);
  EXPECT_EQ(lost->state(), WindowState::lost);
}

// Paused for the picture, one step, then as fast as it goes to the end.
TEST_F(WindowTest, AFlightShowsWhatItSeesAndIsTheSameFlight) {
  const Ran without = run(short_flight({"--json"}));
  cv::Mat paused, stepped;
  const Ran with = run_beside(short_flight({"--json", "--view", "--out", path("out").string()}), [&](pid_t) {
    const Window window = program_window();
    shot_with(window, ink::kBlue, 200);
    display_.press(window, XK_space);
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    paused = display_.screenshot(window);
    EXPECT_EQ(cv::norm(display_.screenshot(window), paused, cv::NORM_INF), 0.0);
    display_.press(window, XK_n);
    EXPECT_TRUE(VirtualDisplay::wait_for([&] {
      stepped = display_.screenshot(window);
      return cv::norm(stepped, paused, cv::NORM_INF) > 0.0;
    }));
    display_.press(window, XK_f);
  });
  EXPECT_EQ(with.exit_code, 0) << with.err;
  EXPECT_EQ(hash_of(with), hash_of(without));
  ASSERT_EQ(paused.size(), cv::Size(854, 480));
  const cv::Mat camera = paused(cv::Rect(0, 0, 640, 480)), panel = paused(cv::Rect(640, 0, 214, 480));
  EXPECT_GT(pixels_of(camera, ink::kBlue), 200) << "the line";
  EXPECT_GT(pixels_of(camera, ink::kSky), 100) << "the outline";
  EXPECT_GT(pixels_of(panel, ink::kVermilion), 20) << "the vehicle on the map";
  EXPECT_GT(pixels_of(panel, ink::kPanel), 30000);
  EXPECT_TRUE(fs::exists(path("out/summary.json")));
}

TEST_F(WindowTest, QuitEndsAFlightAsCtrlCDoes) {
  for (const bool closes : {false, true}) {
    const Ran ran = run_beside(short_flight({"--view", "--out", path("out").string()}), [&](pid_t) {
      const Window window = program_window();
      shot_with(window, ink::kPanel, 1000);
      closes ? display_.close(window) : display_.press(window, XK_q);
    });
    EXPECT_EQ(ran.exit_code, 1) << ran.err;
    EXPECT_EQ(nlohmann::json::parse(read_text(path("out/summary.json")))["outcome"], "aborted");
    fs::remove_all(path("out"));
  }
}

TEST_F(WindowTest, AFlightOutlivesItsDisplay) {
  const Ran ran = run_beside(short_flight({"--view", "--json"}), [&](pid_t) {
    shot_with(program_window(), ink::kPanel, 1000);
    display_.crash();
  });
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_THAT(ran.err, HasSubstr("lineservo: fly: the display is gone; goes on without --view\n"));
  EXPECT_EQ(hash_of(ran), hash_of(run(short_flight({"--json"}))));
}

TEST_F(WindowTest, WatchShowsItsFrames) {
  const Ran ran =
      run_beside({"watch", "sim:straight/node:end", "--conditions", "ideal", "--view"}, [&](pid_t) {
        const auto window = display_.window("lineservo watch sim:straight/node:end");
        ASSERT_TRUE(window);
        shot_with(*window, ink::kBlue, 200);
        display_.press(*window, XK_q);
      });
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_THAT(ran.err, HasSubstr("interrupted after"));
}

class NoDisplayTest : public ProgramTest {
 protected:
  NoDisplayTest() { ::unsetenv("DISPLAY"); }
};

TEST_F(NoDisplayTest, SaysSoAndFliesOn) {
  const Ran without = run(short_flight({"--json"})), with = run(short_flight({"--json", "--view"}));
  EXPECT_EQ(with.exit_code, 0);
  EXPECT_THAT(with.err, HasSubstr("lineservo: fly: --view: DISPLAY is not set; goes on without\n"));
  EXPECT_EQ(nlohmann::json::parse(with.out)["trajectory_sha256"],
            nlohmann::json::parse(without.out)["trajectory_sha256"]);
}

TEST_F(NoDisplayTest, ADisplayThatDoesNotAnswerIsSaid) {
  ::setenv("DISPLAY", ":987", 1);
  const Ran ran = run({"watch", "sim:straight/node:end", "--frames", "3", "--view"});
  ::unsetenv("DISPLAY");
  EXPECT_EQ(ran.exit_code, 0);
  EXPECT_EQ(ran.err, "lineservo: watch: --view: the display :987 does not answer; goes on without\n");
}

}  // namespace
}  // namespace lineservo::apps
