#include "servo/executive/observation_guard.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lineservo::servo {
namespace {

using features::FrameFeatures;

bool finite(double value) {
  return std::isfinite(value);
}
bool finite(const features::LevelPoint& p) {
  return finite(p.x) && finite(p.y);
}
bool finite(const features::PixelPoint& p) {
  return finite(p.x) && finite(p.y);
}
bool finite(const features::LineFeature& l) {
  return finite(l.rho) && finite(l.theta_rad) && finite(l.curvature) && finite(l.begin) && finite(l.end) &&
         finite(l.width);
}
bool finite(const features::JunctionFeature& j) {
  return finite(j.centre) &&
         std::ranges::all_of(j.arms, [](const auto& arm) { return finite(arm.angle_rad); });
}
bool finite(const Motion& m) {
  return m.translation_m.allFinite() && finite(m.yaw_rad);
}

template <typename T>
bool finite_if_any(const std::optional<T>& value) {
  return !value || finite(*value);
}
template <typename T>
void keep_finite(std::optional<T>& value) {
  if (!finite_if_any(value)) value.reset();
}
void keep_finite(std::vector<features::LineFeature>& lines) {
  std::erase_if(lines, [](const features::LineFeature& line) { return !finite(line); });
}

void keep_finite(FrameFeatures& f) {
  keep_finite(f.lines);
  keep_finite(f.junction);
  keep_finite(f.line_end);
  keep_finite(f.centroid_px);
  keep_finite(f.start_marker);
  keep_finite(f.law.centroid);
  keep_finite(f.law.lines);
  keep_finite(f.law.ahead);
  keep_finite(f.law.behind);
  keep_finite(f.law.target);
}

}  // namespace

bool is_finite(const FrameFeatures& f) {
  const auto all_finite = [](const auto& lines) {
    return std::ranges::all_of(lines, [](const features::LineFeature& line) { return finite(line); });
  };
  return all_finite(f.lines) && all_finite(f.law.lines) && finite_if_any(f.junction) &&
         finite_if_any(f.line_end) && finite_if_any(f.centroid_px) && finite_if_any(f.start_marker) &&
         finite_if_any(f.law.centroid) && finite_if_any(f.law.ahead) && finite_if_any(f.law.behind) &&
         finite_if_any(f.law.target);
}

bool is_finite(const StateEstimate& e) {
  const auto& [now, at_capture, height_m, capture_height_m, v_H_m_s, height_age_s, velocity_age_s] = e;
  return finite(now) && finite(at_capture) && finite(height_m) && finite(capture_height_m) &&
         v_H_m_s.allFinite() && finite(height_age_s) && finite(velocity_age_s);
}

const Observation& ObservationGuard::checked(const Observation& observation) {
  const bool features_bad = !is_finite(observation.features);
  const bool estimates_bad = !is_finite(observation.estimate);
  if (features_bad && !features_bad_) news_ = "features that are not finite count as not seen";
  if (estimates_bad && !bad_since_) news_ = "estimates that are not finite: the last good ones stand in";
  features_bad_ = features_bad;
  if (!estimates_bad) bad_since_.reset();
  if (estimates_bad && !bad_since_) bad_since_ = observation.now;
  bad_for_s_ = bad_since_ ? seconds(observation.now - *bad_since_) : 0.0;
  if (!estimates_bad) sound_.estimate = observation.estimate;
  if (!features_bad && !estimates_bad) return observation;
  const StateEstimate last_good = sound_.estimate;
  sound_ = observation;
  sound_.estimate = last_good;
  keep_finite(sound_.features);
  return sound_;
}

std::optional<std::string> ObservationGuard::take_news() {
  return std::exchange(news_, std::nullopt);
}

}  // namespace lineservo::servo
