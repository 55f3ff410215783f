#pragma once

#include <string>

#include "apps/onboard/tick_input.h"
#include "apps/output/command_row.h"
#include "features/frame_features.h"

namespace lineservo::apps {

/// SHA-256 over every bit of every value, as 64 hexadecimal digits. All that are not a number count as equal.
std::string digest(const TickInput& input);
std::string digest(const features::FrameFeatures& features);
std::string digest(const CommandRow& command);

}  // namespace lineservo::apps
