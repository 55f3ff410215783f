#pragma once

#include "features/frame_features.h"
#include "servo/task/command.h"

namespace lineservo::apps {

/// What a controller's chain made of a tick.
struct ChainOutput {
  features::FrameFeatures features;
  servo::Command command;
};

}  // namespace lineservo::apps
