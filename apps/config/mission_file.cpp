#include "apps/config/mission_file.h"

#include <fmt/format.h>

#include "apps/config/data_folder.h"
#include "apps/config/yaml_reader.h"

namespace lineservo::apps {
namespace {

constexpr std::size_t kMostTargets = 200;
constexpr double kLongest_s = 3600.0;
constexpr double kShortestHover_s = 3.0;  // arriving is 2 s at rest

/// Builds a mission from one file.
class MissionReader {
 public:
  explicit MissionReader(const std::filesystem::path& file) : yaml_(file) {}

  MissionFile read() {
    const YAML::Node& root = yaml_.root();
    yaml_.allow(root, {"name", "description", "layout", "targets", "charging_station"}, "a mission");
    mission_.file = yaml_.file();
    mission_.name = yaml_.text(root, "name");
    mission_.description = yaml_.text(root, "description", "no description");
    if (root["layout"]) mission_.layout = beside(yaml_.text(root, "layout"));
    read_targets(root);
    if (root["charging_station"]) read_charging_station(root["charging_station"]);
    return mission_;
  }

 private:
  std::string beside(const std::string& layout) const {
    if (is_shipped(DataKind::layout, layout)) return layout;
    return (yaml_.file().parent_path() / layout).string();
  }

  void read_targets(const YAML::Node& root) {
    const YAML::Node list = root["targets"];
    if (!list || !list.IsSequence() || list.size() == 0 || list.size() > kMostTargets)
      yaml_.fail(list ? list : root,
                 fmt::format("'targets' must be a list of 1 to {} targets", kMostTargets));
    for (const auto& item : list) add(item);
  }

  void add(const YAML::Node& item) {
    if (item.IsScalar()) return add(item, item.Scalar(), {});
    if (!item.IsMap()) yaml_.fail(item, "a target is an instruction, node:NAME or 'return', or {target: …}");
    yaml_.allow(item, {"target", "hover_s", "look", "land", "ground_s"}, "a target");
    add(item, yaml_.text(item, "target"), stop(item));
  }

  void add(const YAML::Node& item, const std::string& target, const servo::Stop& stop) {
    mission_.targets.push_back({target, stop, item.Mark().line + 1});
  }

  servo::Stop stop(const YAML::Node& item) const {
    servo::Stop stop;
    if (item["hover_s"]) stop.hover_s = time_s(item, "hover_s", kShortestHover_s);
    stop.look = yes(item, "look");
    stop.land = yes(item, "land");
    if (!item["ground_s"]) return stop;
    if (!stop.land) yaml_.fail(item["ground_s"], "'ground_s' goes with 'land: true' only");
    stop.ground_s = time_s(item, "ground_s", 0.0);
    return stop;
  }

  double time_s(const YAML::Node& item, const std::string& key, double least_s) const {
    const double value_s = yaml_.number(item, key);
    if (value_s >= least_s && value_s <= kLongest_s) return value_s;
    yaml_.fail(item[key], fmt::format("'{}' must be {} to {} s", key, least_s, kLongest_s));
  }

  bool yes(const YAML::Node& item, const std::string& key) const {
    const std::string text = yaml_.text(item, key, "false");
    if (text != "true" && text != "false") yaml_.fail(item[key], "'" + key + "' must be true or false");
    return text == "true";
  }

  void read_charging_station(const YAML::Node& station) {
    if (!station.IsScalar())
      yaml_.fail(station, "'charging_station' must be an instruction, node:NAME or 'return'");
    servo::Stop stop;
    stop.hover_s = kShortestHover_s;
    stop.land = true;
    add(station, station.Scalar(), stop);
  }

  YamlReader yaml_;
  MissionFile mission_;
};

}  // namespace

bool is_mission_file(const std::string& target) {
  return target.ends_with(".yaml") || target.ends_with(".yml");
}

MissionFile read_mission(const std::filesystem::path& file) {
  return MissionReader(file).read();
}

}  // namespace lineservo::apps
