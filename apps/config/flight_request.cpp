#include "apps/config/flight_request.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

#include "apps/config/conditions_range.h"
#include "apps/config/data_folder.h"
#include "apps/config/input_error.h"
#include "apps/config/mission_file.h"
#include "apps/config/numbers.h"
#include "apps/config/settings_table.h"
#include "apps/config/yaml_reader.h"
#include "apps/version.h"

namespace lineservo::apps {
namespace {

constexpr std::array kMissionKeys = {"version",    "instruction", "controller", "layout",
                                     "conditions", "seed",        "land"};

/// Takes the keys of the mission itself; false when the key is a setting.
bool take_mission_key(FlightRequest& request, const YamlEntry& entry, const std::string& where) {
  if (entry.key == "version") return check_version(entry.text, where), true;
  if (entry.key == "instruction") return request.instruction = entry.text, true;
  if (entry.key == "controller") return request.controller = entry.text, true;
  if (entry.key == "layout") return request.layout = entry.text, true;
  if (entry.key == "conditions") return request.conditions = entry.text, true;
  if (entry.key == "land") {
    if (entry.text != "true" && entry.text != "false")
      throw InputError(where + ": 'land' must be true or false");
    return request.land = entry.text == "true", true;
  }
  if (entry.key == "seed") return request.seed = read_seed(entry.text, where), true;
  return false;
}

/// Gains of an added controller that did not fly: the program that wrote the config need not have known it.
bool is_of_added_other(const std::string& key, const std::string& flown) {
  const auto& all = servo::controllers();
  return std::any_of(all.begin(), all.end(), [&](const servo::Controller& c) {
    return !c.gains.empty() && c.name != flown && key.starts_with("servo." + c.name + ".");
  });
}

/// A default in the place of a key that is missing would be another flight than the config's.
void check_whole(const YamlReader& yaml, const std::vector<YamlEntry>& entries, const SettingsTable& table,
                 const std::string& controller) {
  std::vector<std::string> keys(kMissionKeys.begin(), kMissionKeys.end());
  for (const Setting& setting : table.all()) keys.push_back(setting.key);
  for (const std::string& key : keys) {
    const auto has_key = [&key](const YamlEntry& entry) { return entry.key == key; };
    if (std::none_of(entries.begin(), entries.end(), has_key) && !is_of_added_other(key, controller))
      throw InputError(fmt::format("{}: key '{}' is missing; a config.yaml holds every setting of its flight",
                                   yaml.file().string(), key));
  }
}

std::string where_is(const YamlReader& yaml, const YamlEntry& entry) {
  return fmt::format("{}:{}", yaml.file().string(), entry.line);
}

/// A name that ships, or the path of a file, which a config gives from its own folder.
std::string beside(const std::filesystem::path& config, DataKind kind, const std::string& name_or_path) {
  if (name_or_path.empty() || is_shipped(kind, name_or_path)) return name_or_path;
  return (config.parent_path() / name_or_path).string();
}

/// Double-quoted YAML: any name or path reads back as it was.
std::string quoted(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '"' || c == '\\') escaped += '\\';
    if (static_cast<unsigned char>(c) < 0x20) {
      escaped += fmt::format("\\x{:02x}", static_cast<int>(c));
    } else {
      escaped += c;
    }
  }
  return fmt::format("\"{}\"", escaped);
}

/// Writes "a.b: x" as nested maps, opening the groups that the key before did not have.
class NestedWriter {
 public:
  void add(const std::string& key, const std::string& value) {
    const std::size_t dot = key.rfind('.');
    const std::string group = dot == std::string::npos ? "" : key.substr(0, dot);
    open(group);
    text_ += fmt::format("{:{}}{}: {}\n", "", 2 * depth(group),
                         dot == std::string::npos ? key : key.substr(dot + 1), value);
  }
  const std::string& text() const { return text_; }

 private:
  static std::size_t depth(const std::string& group) {
    return group.empty() ? 0 : 1 + static_cast<std::size_t>(std::count(group.begin(), group.end(), '.'));
  }
  void open(const std::string& group) {
    for (std::size_t end = 0; end < group.size();) {
      end = std::min(group.find('.', end + 1), group.size());
      const std::string prefix = group.substr(0, end);
      const bool is_open = group_ == prefix || group_.rfind(prefix + ".", 0) == 0;
      if (is_open) continue;
      const std::size_t dot = prefix.rfind('.');
      const std::string name = dot == std::string::npos ? prefix : prefix.substr(dot + 1);
      text_ += fmt::format("{:{}}{}:\n", "", 2 * (depth(prefix) - 1), name);
      group_ = prefix;
    }
    group_ = group;
  }

  std::string text_;
  std::string group_;
};

}  // namespace

std::string layout_of_zone(const std::string& instruction) {
  if (is_mission_file(instruction)) {
    const MissionFile mission = read_mission(find_data(DataKind::mission, instruction));
    const std::string& first = mission.targets.front().target;
    if (mission.layout) return *mission.layout;
    return layout_of_zone(is_mission_file(first) ? std::string() : first);  // which is refused later
  }
  switch (instruction.empty() ? '\0' : instruction.front()) {
    case 'b':
      return "square";
    case 'c':
      return "octagon";
    case 'd':
      return "circle";
    default:
      return "warehouse";
  }
}

void check_version(const std::string& version, const std::string& where) {
  if (version == kVersion) return;
  throw InputError(fmt::format("{}: is of version {}, which need not fly as this one does; allowed: {}",
                               where, version, kVersion));
}

std::uint64_t read_seed(const std::string& text, const std::string& where) {
  using Limits = std::numeric_limits<std::uint64_t>;
  const std::optional<std::uint64_t> seed = parse_number(text, Limits::min(), Limits::max());
  if (!seed)
    throw InputError(fmt::format("{}: 'seed' must be a whole number from 0 to {}", where, Limits::max()));
  return *seed;
}

void apply_conditions(FlightRequest& request, const std::string& name_or_path) {
  if (const auto range = conditions_range(name_or_path)) {
    draw_conditions(request, *range);
    request.conditions = name_or_path;
    return;
  }
  const YamlReader yaml(find_data(DataKind::conditions, name_or_path));
  SettingsTable table(request.settings);
  for (const YamlEntry& entry : yaml.scalars()) {
    if (entry.key != "description") table.set(entry.key, entry.text, where_is(yaml, entry));
  }
  request.conditions = name_or_path;
}

void apply_override(FlightRequest& request, const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw InputError(
        fmt::format("--set '{}': must be KEY=VALUE, such as camera.frame_rate_hz=30", assignment));
  }
  SettingsTable(request.settings).set(assignment.substr(0, equals), assignment.substr(equals + 1), "--set");
}

FlightRequest read_config(const std::filesystem::path& file) {
  const YamlReader yaml(file);
  FlightRequest request;
  SettingsTable table(request.settings);
  const std::vector<YamlEntry> entries = yaml.scalars();
  for (const YamlEntry& entry : entries) {
    const std::string where = where_is(yaml, entry);
    if (!take_mission_key(request, entry, where)) table.set(entry.key, entry.text, where);
  }
  check_whole(yaml, entries, table, request.controller);
  if (is_mission_file(request.instruction))
    request.instruction = beside(file, DataKind::mission, request.instruction);
  request.layout = beside(file, DataKind::layout, request.layout);
  if (!conditions_range(request.conditions))
    request.conditions = beside(file, DataKind::conditions, request.conditions);
  return request;
}

std::string config_text(const FlightRequest& request) {
  FlightRequest copy = request;
  NestedWriter writer;
  writer.add("version", std::string(kVersion));
  writer.add("instruction", quoted(request.instruction));
  writer.add("controller", quoted(request.controller));
  writer.add("layout", quoted(request.layout));
  writer.add("conditions", quoted(request.conditions));
  writer.add("seed", fmt::format("{}", request.seed));
  writer.add("land", request.land ? "true" : "false");
  const SettingsTable table(copy.settings);
  for (const Setting& setting : table.all()) writer.add(setting.key, setting.get());
  return writer.text();
}

}  // namespace lineservo::apps
