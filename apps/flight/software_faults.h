#pragma once

#include <memory>

#include "features/frame_features.h"
#include "servo/law/follow_law.h"
#include "vehicle/fault_window.h"

namespace lineservo::apps {

/// What can go wrong between the image and the command, each at a time of its own.
struct SoftwareFaultOptions {
  vehicle::FaultWindow features_nan;  ///< perception: every number of lines and junction
  vehicle::FaultWindow estimate_nan;  ///< what the laws are told of velocity, height and place
  vehicle::FaultWindow law_nan;       ///< what the law that follows says
  vehicle::FaultWindow misread;       ///< every frame reads this code, whatever is in view
  features::JunctionCode misread_code = features::JunctionCode::cross;
};

/// Spoils what perception says of the frame that was taken at t.
void spoil(features::FrameFeatures& features, const SoftwareFaultOptions& options, vehicle::Time t);
/// Spoils the estimates of a tick at t.
void spoil(servo::Observation& observation, const SoftwareFaultOptions& options, vehicle::Time t);
/// The law, saying what is no number at its time.
std::unique_ptr<servo::FollowLaw> spoilt(std::unique_ptr<servo::FollowLaw> law,
                                         const SoftwareFaultOptions& options);

}  // namespace lineservo::apps
