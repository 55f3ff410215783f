#pragma once

#include "apps/overlay/canvas.h"
#include "features/junction/junction_code.h"
#include "servo/plan/plan.h"

namespace lineservo::apps {

/// Draws a code as the arms that it stands for, forward up: J0 a disc, J1 a question mark.
void draw_sign(Canvas& canvas, cv::Point2d centre, double radius_px, features::JunctionCode code);
/// Draws how a node looks: bends and forks by their arms, others by their code.
void draw_sign(Canvas& canvas, cv::Point2d centre, double radius_px, const servo::NodeSignature& node);

/// "J3", "fork", "bend left".
std::string short_name(const servo::NodeSignature& node);

}  // namespace lineservo::apps
