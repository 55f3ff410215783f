#pragma once

#include <yaml-cpp/yaml.h>

#include <filesystem>
#include <string>
#include <vector>

namespace lineservo::apps {

/// One scalar of a YAML file: its dotted key, its text and where it stands.
struct YamlEntry {
  std::string key;
  std::string text;
  int line = 0;
};

/// Reads YAML strictly: every complaint names file, line and key; keys that nobody asked for are errors.
class YamlReader {
 public:
  /// Throws InputError when the file cannot be read, is not YAML, has anchors or aliases, a key twice or a
  /// second document, or is not a map.
  explicit YamlReader(const std::filesystem::path& file);
  /// The same of a text that stands in the file.
  YamlReader(const std::filesystem::path& file, const std::string& text);

  const YAML::Node& root() const { return root_; }
  const std::filesystem::path& file() const { return file_; }

  /// All scalars below the root, keys joined by dots. Throws InputError for lists, where only scalars are
  /// expected.
  std::vector<YamlEntry> scalars() const;

  /// Typed access to a map's member; throws InputError when it is missing or not of the type.
  double number(const YAML::Node& map, const std::string& key) const;
  std::string text(const YAML::Node& map, const std::string& key) const;
  /// The same with a value for a key that is absent.
  double number(const YAML::Node& map, const std::string& key, double otherwise) const;
  std::string text(const YAML::Node& map, const std::string& key, const std::string& otherwise) const;
  /// A list of numbers of a given length.
  std::vector<double> numbers(const YAML::Node& map, const std::string& key, std::size_t count) const;
  std::vector<double> number_list(const YAML::Node& list, const std::string& what, std::size_t count) const;

  /// Throws InputError when the map has a key that is not among the allowed ones.
  void allow(const YAML::Node& map, const std::vector<std::string>& keys, const std::string& what) const;

  /// Throws InputError: "FILE:LINE: message".
  [[noreturn]] void fail(const YAML::Node& at, const std::string& message) const;

 private:
  std::filesystem::path file_;
  YAML::Node root_;
};

}  // namespace lineservo::apps
