#pragma once

#include <array>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

namespace lineservo::apps {

/// What the plots show of a tick; nan is what is absent. (Also read by the module of ViSP's windows, which is
/// C++17.)
struct PlotSample {
  double time_s = 0.0;
  std::array<double, 3> features;  ///< line ρ, line θ in rad, distance of the junction in m
  std::array<double, 5>
      velocities;  ///< commanded forward, left (m/s), yaw rate (rad/s); estimated forward, left
};

enum class ViewKey { pause, step, fast, quit };

enum class WindowState {
  open,
  closed,  ///< by the user
  lost,    ///< with the display
};

struct WindowSpec {
  std::string title;
  cv::Size size;
};

/// Two windows on a screen: one that shows pictures and one with plots.
class ViewWindow {
 public:
  ViewWindow() = default;
  virtual ~ViewWindow() = default;
  ViewWindow(const ViewWindow&) = delete;
  ViewWindow& operator=(const ViewWindow&) = delete;

  /// CV_8UC3 (BGR) of the spec's size.
  virtual void show(const cv::Mat& picture) = 0;
  virtual void plot(const PlotSample& sample) = 0;
  /// The next key that was pressed; none when there is none that counts.
  virtual std::optional<ViewKey> key() = 0;
  /// Nothing is shown any more unless it is open.
  virtual WindowState state() const = 0;
};

}  // namespace lineservo::apps
