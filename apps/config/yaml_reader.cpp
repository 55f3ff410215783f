#include "apps/config/yaml_reader.h"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

#include "apps/config/input_error.h"
#include "apps/config/text_file.h"

namespace lineservo::apps {
namespace {

int line_of(const YAML::Node& node) {
  return node.Mark().line + 1;
}

std::string joined(const std::vector<std::string>& words) {
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
  return list;
}

/// Refuses what no file of ours needs, before anything is built of it: a few aliases of aliases make a tree
/// that no memory holds.
class Gate : public YAML::EventHandler {
 public:
  explicit Gate(const std::filesystem::path& file) : file_(file) {}

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (++documents_ == 1) return;
    throw InputError(fmt::format("{}:{}: a second document (after --- or ...) is not allowed", file_.string(),
                                 mark.line + 1));
  }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override { check(mark, anchor); }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override { refuse(mark); }
  void OnScalar(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                const std::string&) override {
    check(mark, anchor);
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    check(mark, anchor);
  }
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    check(mark, anchor);
  }
  void OnMapEnd() override {}

 private:
  void check(const YAML::Mark& mark, YAML::anchor_t anchor) const {
    if (anchor != 0) refuse(mark);
  }
  [[noreturn]] void refuse(const YAML::Mark& mark) const {
    throw InputError(
        fmt::format("{}:{}: anchors (&x) and aliases (*x) are not allowed", file_.string(), mark.line + 1));
  }

  const std::filesystem::path& file_;
  int documents_ = 0;
};

YAML::Node load(const std::filesystem::path& file, const std::string& text) try {
  std::istringstream stream(text);
  Gate gate(file);
  YAML::Parser parser(stream);
  while (parser.HandleNextDocument(gate)) {
  }
  return YAML::Load(text);
} catch (const YAML::Exception& error) {
  throw InputError(file.string() + ":" + std::to_string(error.mark.line + 1) + ": not YAML: " + error.msg);
}

/// Deeper than any file of ours.
constexpr int kDeepest = 32;

void refuse_double_keys(const YamlReader& reader, const YAML::Node& node, int depth = 0) {
  if (depth > kDeepest) reader.fail(node, "nested too deeply");
  if (!node.IsMap()) {
    for (const auto& item : node) {
      if (node.IsSequence()) refuse_double_keys(reader, item, depth + 1);
    }
    return;
  }
  std::set<std::string> seen;
  for (const auto& pair : node) {
    if (!pair.first.IsScalar()) reader.fail(pair.first, "a key must be a word");
    if (!seen.insert(pair.first.Scalar()).second)
      reader.fail(pair.first, "key '" + pair.first.Scalar() + "' twice");
    refuse_double_keys(reader, pair.second, depth + 1);
  }
}

void collect(const YamlReader& reader, const YAML::Node& node, const std::string& prefix,
             std::vector<YamlEntry>& into) {
  for (const auto& pair : node) {
    const std::string key = prefix + pair.first.Scalar();
    if (pair.second.IsMap()) {
      collect(reader, pair.second, key + ".", into);
    } else if (pair.second.IsScalar()) {
      into.push_back({key, pair.second.Scalar(), line_of(pair.first)});
    } else {
      reader.fail(pair.first, "key '" + key + "' needs a single value");
    }
  }
}

}  // namespace

YamlReader::YamlReader(const std::filesystem::path& file) : YamlReader(file, read_text_file(file)) {}

YamlReader::YamlReader(const std::filesystem::path& file, const std::string& text)
    : file_(file), root_(load(file, text)) {
  if (!root_.IsMap()) throw InputError(file.string() + ": must be a map of keys to values");
  refuse_double_keys(*this, root_);
}

std::vector<YamlEntry> YamlReader::scalars() const {
  std::vector<YamlEntry> entries;
  collect(*this, root_, "", entries);
  std::map<std::string, int> lines;  // a.b: 1 beside a: {b: 1} is the same key
  for (const YamlEntry& entry : entries) {
    if (const auto [first, is_new] = lines.try_emplace(entry.key, entry.line); !is_new)
      throw InputError(fmt::format("{}:{}: key '{}' twice, first in line {}", file_.string(), entry.line,
                                   entry.key, first->second));
  }
  return entries;
}

double YamlReader::number(const YAML::Node& map, const std::string& key) const {
  const YAML::Node node = map[key];
  if (!node) fail(map, "key '" + key + "' is missing");
  double value = 0.0;
  if (!node.IsScalar() || !YAML::convert<double>::decode(node, value) || !std::isfinite(value)) {
    fail(node, "key '" + key + "' must be a finite number");
  }
  return value;
}

std::string YamlReader::text(const YAML::Node& map, const std::string& key) const {
  const YAML::Node node = map[key];
  if (!node) fail(map, "key '" + key + "' is missing");
  if (!node.IsScalar() || node.Scalar().empty()) fail(node, "key '" + key + "' must be a word");
  return node.Scalar();
}

double YamlReader::number(const YAML::Node& map, const std::string& key, double otherwise) const {
  return map[key] ? number(map, key) : otherwise;
}

std::string YamlReader::text(const YAML::Node& map, const std::string& key,
                             const std::string& otherwise) const {
  return map[key] ? text(map, key) : otherwise;
}

std::vector<double> YamlReader::numbers(const YAML::Node& map, const std::string& key,
                                        std::size_t count) const {
  if (!map[key]) fail(map, "key '" + key + "' is missing");
  return number_list(map[key], "key '" + key + "'", count);
}

std::vector<double> YamlReader::number_list(const YAML::Node& list, const std::string& what,
                                            std::size_t count) const {
  const std::string need = what + " must be a list of " + std::to_string(count) + " finite numbers";
  if (!list.IsSequence() || list.size() != count) fail(list, need);
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (!YAML::convert<double>::decode(list[i], values[i]) || !std::isfinite(values[i])) fail(list, need);
  }
  return values;
}

void YamlReader::allow(const YAML::Node& map, const std::vector<std::string>& keys,
                       const std::string& what) const {
  if (!map.IsMap()) fail(map, what + " must be a map with " + joined(keys));
  for (const auto& pair : map) {
    const std::string& key = pair.first.Scalar();
    if (std::find(keys.begin(), keys.end(), key) == keys.end()) {
      fail(pair.first, fmt::format("unknown key '{}' of {}; allowed: {}", key, what, joined(keys)));
    }
  }
}

void YamlReader::fail(const YAML::Node& at, const std::string& message) const {
  throw InputError(file_.string() + ":" + std::to_string(line_of(at)) + ": " + message);
}

}  // namespace lineservo::apps
