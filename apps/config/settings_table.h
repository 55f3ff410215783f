#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "apps/config/settings.h"

namespace lineservo::apps {

/// From where to where a number may be, both included.
struct NumberRange {
  double low, high;
};

/// One setting by its name: how to read it from text and how to write it so that it reads back to the last
/// bit.
struct Setting {
  std::string key;
  std::string allowed;                          ///< for messages: "a number from 0 to 1"
  std::function<bool(const std::string&)> set;  ///< false when the text is not allowed
  std::function<std::string()> get;
  std::optional<NumberRange> range = {};  ///< of a number that need not be whole
};

/// The names of all settings, bound to one Settings object: the only place where a key meets its variable.
class SettingsTable {
 public:
  /// `settings` must outlive the table.
  explicit SettingsTable(Settings& settings);

  const std::vector<Setting>& all() const { return table_; }
  /// Throws InputError, behind `where`, for an unknown key or a value that is not allowed.
  void set(const std::string& key, const std::string& text, const std::string& where);

 private:
  void bind_general(Settings& s);
  void bind_wind(WindSettings& w);
  void bind_camera(CameraSettings& c);
  void bind_floor(FloorSettings& f);
  void bind_features(FeatureSettings& f);
  void bind_sensors(SensorSettings& s);
  void bind_vehicle(vehicle::AirframeParameters& a);
  void bind_rotor_places(vehicle::AirframeParameters& a);
  void bind_autopilot(vehicle::AutopilotOptions& o);
  void bind_laws(servo::LawOptions& l);
  void bind_ibvs(servo::IbvsLineOptions& o);
  void bind_ibvs_point(const std::string& prefix, servo::IbvsPointOptions& o);
  void bind_pid(servo::PidOptions& o);
  void bind_grid(servo::GridOptions& o);
  void bind_lfpf(servo::LfpfOptions& o);
  void bind_carrot(servo::CarrotOptions& o);
  void bind_improved_carrot(servo::ImprovedCarrotOptions& o);
  void bind_vtp(servo::VtpOptions& o);
  void bind_own(servo::LawOptions& l);
  void bind_faults(FaultSettings& f);
  void bind_executive(servo::ExecutiveOptions& e);

  void window(const std::string& key, vehicle::FaultWindow& value);
  void number(std::string key, double& value, double low, double high);
  void whole(std::string key, int& value, std::vector<int> choices);
  void whole(std::string key, int& value, int low, int high);
  void word(std::string key, std::string& value, std::vector<std::string> choices);
  void yes_no(std::string key, bool& value);
  void interaction(std::string key, servo::InteractionMatrix& value);
  void gain(const std::string& prefix, servo::AdaptiveGain& gain);
  void pid_gains(const std::string& prefix, servo::PidGains& g);

  std::vector<Setting> table_;
};

}  // namespace lineservo::apps
