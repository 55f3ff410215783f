#include "apps/flight/software_faults.h"

#include <limits>
#include <utility>

namespace lineservo::apps {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

class SpoiltLaw final : public servo::FollowLaw {
 public:
  SpoiltLaw(std::unique_ptr<servo::FollowLaw> law, const vehicle::FaultWindow& window)
      : law_(std::move(law)), window_(window) {}
  void reset() override { law_->reset(); }
  servo::Command follow(const servo::Observation& o, const servo::FollowGoal& goal) override {
    const servo::Command command = law_->follow(o, goal);
    return window_.holds(o.now) ? servo::Command(servo::VelocityCommand{kNaN, kNaN, kNaN, kNaN}) : command;
  }
  std::optional<servo::Command> hover(const servo::Observation& o, const servo::FollowGoal& goal) override {
    return law_->hover(o, goal);
  }

 private:
  std::unique_ptr<servo::FollowLaw> law_;
  vehicle::FaultWindow window_;
};

}  // namespace

void spoil(features::FrameFeatures& f, const SoftwareFaultOptions& options, vehicle::Time t) {
  if (options.misread.holds(t)) f.code = {options.misread_code, options.misread_code, options.misread_code};
  if (!options.features_nan.holds(t)) return;
  for (auto* lines : {&f.lines, &f.law.lines})
    for (features::LineFeature& line : *lines) line.rho = line.theta_rad = kNaN;
  if (f.junction) f.junction->centre = {kNaN, kNaN};
  if (f.law.centroid) f.law.centroid = features::LevelPoint{kNaN, kNaN};
  if (f.law.target) f.law.target = features::LevelPoint{kNaN, kNaN};
  if (f.law.ahead) f.law.ahead = features::LevelPoint{kNaN, kNaN};
  if (f.centroid_px) f.centroid_px->x = kNaN;
}

void spoil(servo::Observation& o, const SoftwareFaultOptions& options, vehicle::Time t) {
  if (!options.estimate_nan.holds(t)) return;
  o.estimate.v_H_m_s.setConstant(kNaN);
  o.estimate.height_m = o.estimate.capture_height_m = kNaN;
  o.estimate.odometry_now.translation_m.setConstant(kNaN);
}

std::unique_ptr<servo::FollowLaw> spoilt(std::unique_ptr<servo::FollowLaw> law,
                                         const SoftwareFaultOptions& options) {
  if (!options.law_nan.is_set()) return law;
  return std::make_unique<SpoiltLaw>(std::move(law), options.law_nan);
}

}  // namespace lineservo::apps
