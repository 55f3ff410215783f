#include "vehicle/sensors/sensor_parameters.h"

#include "vehicle/faults.h"

namespace lineservo::vehicle {

SensorParameters SensorParameters::ideal() {
  SensorParameters p;
  p.gyro_sigma_rad_s = p.gyro_bias_rad_s = 0.0;
  p.accelerometer_sigma_m_s2 = p.accelerometer_bias_m_s2 = 0.0;
  p.attitude_sigma_rad = p.tilt_offset_rad = 0.0;
  p.flow_sigma_m_s = p.flow_bias_m_s = p.flow_bias_start_m_s = 0.0;
  p.range_sigma_m = 0.0;
  return p;
}

void SensorParameters::validate() const {
  Faults faults("sensors");
  faults.require_not_negative(gyro_sigma_rad_s, "gyro_sigma_rad_s");
  faults.require_not_negative(gyro_bias_rad_s, "gyro_bias_rad_s");
  faults.require_not_negative(accelerometer_sigma_m_s2, "accelerometer_sigma_m_s2");
  faults.require_not_negative(accelerometer_bias_m_s2, "accelerometer_bias_m_s2");
  faults.require_not_negative(attitude_sigma_rad, "attitude_sigma_rad");
  faults.require_positive(attitude_correlation_s, "attitude_correlation_s");
  faults.require_not_negative(tilt_offset_rad, "tilt_offset_rad");
  faults.require_not_negative(flow_sigma_m_s, "flow_sigma_m_s");
  faults.require_not_negative(flow_bias_m_s, "flow_bias_m_s");
  faults.require_not_negative(flow_bias_start_m_s, "flow_bias_start_m_s");
  faults.require_positive(flow_bias_correlation_s, "flow_bias_correlation_s");
  faults.require_not_negative(range_sigma_m, "range_sigma_m");
  faults.throw_if_any();
}

}  // namespace lineservo::vehicle
