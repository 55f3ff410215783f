#include "servo/law/lfpf_law.h"

#include <cmath>

#include "servo/law/published_followers.h"

namespace lineservo::servo {

using features::LineFeature;
using features::radians;

namespace {

const LineFeature* fitted_line(const Observation& o) {
  const std::vector<LineFeature>& lines = o.features.law.lines;
  return lines.empty() ? nullptr : &lines.front();
}

const LineFeature kStraightAhead{};

/// The law's own line. Over a junction, where the fit would be of both stripes, the one that is led along;
/// when that is not in view either, straight on.
const LineFeature* line_of(const Observation& o) {
  const LineFeature* line = on_plain_line(o) ? fitted_line(o) : line_to_follow(o);
  const bool usable = line && (line->begin.vector() + line->end.vector()).allFinite() &&
                      std::abs(line->theta_rad) <= kFollowable_rad;
  if (usable) return line;
  return on_plain_line(o) ? nullptr : &kStraightAhead;
}

}  // namespace

// Alg. 3, line 3: θ = yaw = atan(v_y / v_x) is 90° for a centred forward line and is commanded as an angle.
// The evident intent is the line's direction off straight ahead, 90° − θ, to be turned out. LineFeature's θ
// is that angle, clockwise positive; the yaw rate is counter-clockwise positive.
Command LfpfLaw::follow(const Observation& observation, const FollowGoal& goal) {
  const LineFeature* line = line_of(observation);
  if (!line) return level_flight(goal);
  const double pitch = pitch_rad(*line, goal.speed_m_s) +
                       speed_hold(observation, goal.speed_m_s, options_.speed_hold_rad_per_m_s);
  return AttitudeCommand{roll_rad(*line), pitch, -options_.yaw_gain_per_s * line->theta_rad, goal.height_m};
}

// roll = c_1 (1 / (1 + exp((x_i − x)/80)) − 0.5)   (Alg. 3, line 4), with x_i of the line's midpoint s and x
// of the image's centre. As printed a line on the right (x_i > x) gives a negative roll; here roll > 0 is
// right side down, towards such a line, so the sign is turned.
double LfpfLaw::roll_rad(const LineFeature& line) const {
  const double off_px = 0.5 * kPublishedFocal_px * (line.begin.x + line.end.x);  // x_i − x
  return -radians(options_.c1_deg) * (1.0 / (1.0 + std::exp(off_px / options_.sigmoid_px)) - 0.5);
}

// pitch = c_2 sinθ + b   (Alg. 3, line 5), with the θ of the paper, 90° for a forward line: sinθ is the
// cosine of ours. In proportion to the speed, so that laws can be compared at one.
double LfpfLaw::pitch_rad(const LineFeature& line, double speed_m_s) const {
  const double printed_deg = options_.c2_deg * std::cos(line.theta_rad) + options_.b_deg;
  return radians(printed_deg) * speed_m_s / options_.pitch_speed_m_s;
}

}  // namespace lineservo::servo
