#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "apps/config/settings.h"

namespace lineservo::apps {

/// Everything that decides a flight: what `fly` was asked for, with every setting in force.
struct FlightRequest {
  std::string instruction;
  std::string controller = "ibvs";
  std::string layout = "warehouse";
  std::string conditions = "paper";
  std::uint64_t seed = 1;
  bool land = false;
  Settings settings;
};

/// A seed as text: a whole number from 0. Throws InputError behind `where`.
std::uint64_t read_seed(const std::string& text, const std::string& where);

/// Throws InputError behind `where` for results of another version of the program.
void check_version(const std::string& version, const std::string& where);

/// Puts the settings of conditions (a name that ships, or a file) over those of the request. Of a pair
/// ("paper..harsh") the request's seed draws conditions between the two: set it first.
void apply_conditions(FlightRequest& request, const std::string& name_or_path);

/// Puts one KEY=VALUE over those of the request. Throws InputError.
void apply_override(FlightRequest& request, const std::string& assignment);

/// The floor that ships for the zone of an instruction (b02: square); warehouse for what names no zone. For a
/// mission file the layout that it names, or the floor of the zone of its first target; throws InputError
/// when it cannot be read.
std::string layout_of_zone(const std::string& instruction);

/// Reads a config.yaml: the request of an earlier flight. Paths of a layout and of conditions are taken from
/// the folder of the config. Throws InputError naming file, line and key; also for a key that is missing and
/// for a config of another version.
FlightRequest read_config(const std::filesystem::path& file);

/// The request as config.yaml, with the program's version; reads back to the last bit.
std::string config_text(const FlightRequest& request);

}  // namespace lineservo::apps
