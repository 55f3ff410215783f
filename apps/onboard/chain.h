#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>

#include "apps/config/settings.h"
#include "apps/onboard/tick_input.h"
#include "features/geometry/camera_model.h"
#include "features/perception.h"
#include "servo/law/controllers.h"
#include "servo/task/command.h"

namespace lineservo::apps {

/// What the vehicle's computer does with a frame: image → features → command. A flight, watch and replay run
/// the same chains; the same inputs give the same features and commands to the last bit.
class Chain {
 public:
  /// Throws std::invalid_argument for a camera or options out of bounds.
  Chain(const features::CameraParameters& camera, const Settings& settings,
        const servo::Controller& controller);
  virtual ~Chain() = default;
  Chain(const Chain&) = delete;
  Chain& operator=(const Chain&) = delete;

  /// Perception; once for each tick that has a frame, before command().
  features::FrameFeatures see(const TickInput& input, const cv::Mat& bgr);
  /// Control; once for each tick, with empty features when it has no frame.
  servo::Command command(const TickInput& input, features::FrameFeatures features);

  /// What the last command rests on.
  const servo::Observation& observation() const { return observation_; }
  /// The path in the last frame that was seen; there must have been one.
  const features::PackedMask& mask() const { return perception_.mask(); }
  /// The level camera of the last frame that was seen, in which its features lie.
  const features::LevelView& view() const { return view_; }
  /// The camera in which the law's own features lie: level, or as it hangs.
  features::LevelView law_view() const { return law_corrects_tilt_ ? view_ : features::LevelView(); }

 protected:
  /// The vehicle follows an edge, rather than being placed or turned on the spot.
  virtual bool on_the_way() const = 0;
  virtual servo::Command decide(const servo::Observation& observation, bool on_ground) = 0;

 private:
  features::Perception perception_;
  bool corrects_tilt_, law_corrects_tilt_;
  features::LevelView view_;
  SoftwareFaultOptions faults_;
  servo::Time last_exposed_{0};  ///< of the last frame that perception saw
  long ticks_ = 0;
  servo::Observation observation_;
};

}  // namespace lineservo::apps
