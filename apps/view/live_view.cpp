#include "apps/view/live_view.h"

#include <limits>

#include "apps/view/load_window.h"

namespace lineservo::apps {
namespace {

constexpr double kAbsent = std::numeric_limits<double>::quiet_NaN();

}  // namespace

PlotSample sample_of(const OverlayScene& scene, const TickInput& input) {
  PlotSample sample{scene.time_s, {kAbsent, kAbsent, kAbsent}, {kAbsent, kAbsent, kAbsent, kAbsent, kAbsent}};
  const features::FrameFeatures& seen = scene.features;
  auto& [rho, theta_rad, junction_m] = sample.features;
  if (const features::LineFeature* line = seen.line()) {
    rho = line->rho;
    theta_rad = line->theta_rad;
  }
  if (seen.junction) junction_m = seen.junction->centre.vector().norm() * input.estimate.capture_height_m;
  auto& [forward, left, yaw_rate, forward_estimated, left_estimated] = sample.velocities;
  if (const auto* velocity = std::get_if<servo::VelocityCommand>(&scene.command)) {
    forward = velocity->forward_m_s;
    left = velocity->left_m_s;
    yaw_rate = velocity->yaw_rate_rad_s;
  } else if (const auto* attitude = std::get_if<servo::AttitudeCommand>(&scene.command)) {
    yaw_rate = attitude->yaw_rate_rad_s;
  }
  forward_estimated = input.estimate.v_H_m_s.x();
  left_estimated = input.estimate.v_H_m_s.y();
  return sample;
}

LiveView::LiveView(Overlay overlay, std::unique_ptr<ViewWindow> window, std::function<bool()> goes_on)
    : overlay_(std::move(overlay)), view_(std::move(window), ViewPace::real_time, std::move(goes_on)) {}

void LiveView::show(const OverlayScene& scene, const TickInput& input) {
  view_.show(
      scene.time_s, [&]() -> const cv::Mat& { return overlay_.draw(scene); }, sample_of(scene, input));
}

std::unique_ptr<LiveView> open_live_view(Overlay overlay, const std::string& title,
                                         std::function<bool()> goes_on, std::string& complaint) {
  std::unique_ptr<ViewWindow> window = load_window({title, overlay.size()}, complaint);
  if (!window) return nullptr;
  return std::make_unique<LiveView>(std::move(overlay), std::move(window), std::move(goes_on));
}

}  // namespace lineservo::apps
