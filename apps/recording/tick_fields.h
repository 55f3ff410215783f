#pragma once

#include "apps/onboard/tick_input.h"

namespace lineservo::apps {

/// Calls visit(name, value) for every value of a tick's input, a TickInput or a const one: the columns of
/// recording.csv in their order. Values are servo::Time, double or bool.
template <typename Input, typename Visit>
void for_each_field(Input& i, Visit visit) {
  visit("t_ns", i.now);
  visit("captured_ns", i.captured);
  visit("has_frame", i.has_frame);
  visit("exposed_ns", i.exposed);
  visit("roll_rad", i.roll_rad);
  visit("pitch_rad", i.pitch_rad);
  auto& [odometry_now, odometry_at_capture, height_m, capture_height_m, v_H_m_s, height_age_s,
         velocity_age_s] = i.estimate;
  visit("capture_height_m", capture_height_m);
  visit("height_m", height_m);
  visit("forward_m_s", v_H_m_s.x());
  visit("left_m_s", v_H_m_s.y());
  visit("up_m_s", v_H_m_s.z());
  visit("odometry_x_m", odometry_now.translation_m.x());
  visit("odometry_y_m", odometry_now.translation_m.y());
  visit("odometry_yaw_rad", odometry_now.yaw_rad);
  visit("capture_odometry_x_m", odometry_at_capture.translation_m.x());
  visit("capture_odometry_y_m", odometry_at_capture.translation_m.y());
  visit("capture_odometry_yaw_rad", odometry_at_capture.yaw_rad);
  visit("height_age_s", height_age_s);
  visit("velocity_age_s", velocity_age_s);
  visit("on_ground", i.on_ground);
}

}  // namespace lineservo::apps
