#include "apps/config/camera/yaml_entries.h"

namespace lineservo::apps {
namespace {

void collect_words(const YAML::Node& node, std::vector<std::string>& words) {
  if (node.IsScalar()) words.push_back(node.Scalar());
  if (!node.IsSequence()) return;
  for (const auto& item : node) collect_words(item, words);
}

std::vector<std::string> words_of(const YamlReader& yaml, const YAML::Node& node) {
  std::vector<std::string> words;
  if (!node.IsMap() || !node["data"]) {
    collect_words(node, words);
    return words;
  }
  collect_words(node["data"], words);
  const double count = yaml.number(node, "rows") * yaml.number(node, "cols");
  if (count != static_cast<double>(words.size()))
    yaml.fail(node["data"], "key 'data' must be as many numbers as 'rows' times 'cols'");
  return words;
}

}  // namespace

CameraEntries entries_of(const YamlReader& yaml, const YAML::Node& map) {
  CameraEntries entries(yaml.file(), map.Mark().line + 1);
  for (const auto& pair : map)
    entries.add({pair.first.Scalar(), words_of(yaml, pair.second), pair.first.Mark().line + 1});
  return entries;
}

}  // namespace lineservo::apps
