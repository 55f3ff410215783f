#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "servo/plan/plan.h"

namespace lineservo::apps {

/// A target that leads back to the take-off point.
inline constexpr std::string_view kReturn = "return";

/// One target of a mission file and what is done there.
struct MissionTarget {
  std::string target;  ///< an instruction, node:NAME, or kReturn
  servo::Stop stop;
  int line = 0;  ///< of the file
};

/// A mission as it is written (data/missions/README.md).
struct MissionFile {
  std::filesystem::path file;
  std::string name, description;
  std::optional<std::string> layout;   ///< a name that ships, or a path
  std::vector<MissionTarget> targets;  ///< the charging station last
};

/// Whether a TARGET names a mission file: it ends in .yaml or .yml.
bool is_mission_file(const std::string& target);

/// Reads a mission. Keys: name, description, layout, targets [TARGET or {target, hover_s, look, land,
/// ground_s}], charging_station. Throws InputError naming file, line and key.
MissionFile read_mission(const std::filesystem::path& file);

}  // namespace lineservo::apps
