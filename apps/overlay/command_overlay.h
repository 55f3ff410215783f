#pragma once

#include "apps/overlay/canvas.h"
#include "servo/task/command.h"

namespace lineservo::apps {

/// Draws a command about the middle of `area`, seen from above with forward up: forward and sideways as
/// arrows, the yaw rate as an arc of what one second turns by, climbing and sinking as an arrow at the left
/// border. A speed of `full_m_s` is an arrow of 90 px; of attitudes a tilt of 5° is. A landing is a ring
/// about the middle.
void draw_command(Canvas& canvas, const cv::Rect& area, const servo::Command& command, double full_m_s);

}  // namespace lineservo::apps
