#include "apps/config/data_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "apps/config/input_error.h"
#include "apps/config/program_files.h"
#include "apps/config/yaml_reader.h"

namespace lineservo::apps {
namespace {

namespace fs = std::filesystem;

std::string folder_of(DataKind kind) {
  return kind == DataKind::layout ? "layouts" : kind == DataKind::mission ? "missions" : "conditions";
}
std::string word_for(DataKind kind) {
  return kind == DataKind::layout ? "layout" : kind == DataKind::mission ? "mission" : "conditions";
}
std::string name_of(DataKind kind, const fs::path& file) {
  return (kind == DataKind::mission ? file.filename() : file.stem()).string();
}
bool is_own_file(const std::string& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

/// data/ of the source tree or share/lineservo/data of an installation.
fs::path data_root() {
  if (const char* set = std::getenv("LINESERVO_DATA")) return set;
  const auto layouts = find_program_file({"share/lineservo/data/layouts", "data/layouts"});
  if (!layouts) throw InputError("the data folder of lineservo was not found; set LINESERVO_DATA to it");
  return layouts->parent_path();
}

std::vector<fs::path> shipped(DataKind kind) {
  const fs::path folder = data_root() / folder_of(kind);
  std::error_code error;
  if (!fs::is_directory(folder, error)) {
    throw InputError(fmt::format("{}: is not a folder; LINESERVO_DATA must name the data folder of lineservo",
                                 folder.string()));
  }
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".yaml") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

fs::path find_data(DataKind kind, const std::string& name_or_path) {
  if (kind == DataKind::mission && is_own_file(name_or_path)) return name_or_path;
  std::string names;
  for (const fs::path& file : shipped(kind)) {
    if (name_of(kind, file) == name_or_path) return file;
    names += (names.empty() ? "" : ", ") + name_of(kind, file);
  }
  if (is_own_file(name_or_path)) return name_or_path;
  throw InputError(fmt::format("no {} '{}': give the path of a YAML file or one of: {}", word_for(kind),
                               name_or_path, names));
}

bool is_shipped(DataKind kind, const std::string& name) {
  if (kind == DataKind::mission && is_own_file(name)) return false;
  const std::vector<fs::path> files = shipped(kind);
  return std::any_of(files.begin(), files.end(),
                     [&](const fs::path& file) { return name_of(kind, file) == name; });
}

std::string shipped_text(const fs::path& file) {
  std::ifstream stream(data_root() / file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream) throw InputError(fmt::format("{}: cannot be read in the data folder", file.string()));
  return text;
}

std::optional<fs::path> shipped_file(const fs::path& file) {
  const fs::path path = data_root() / file;
  std::error_code error;
  return fs::is_regular_file(path, error) ? std::optional(path) : std::nullopt;
}

std::vector<DataEntry> list_data(DataKind kind) {
  std::vector<DataEntry> entries;
  for (const fs::path& file : shipped(kind)) {
    const YamlReader yaml(file);
    entries.push_back({name_of(kind, file), yaml.text(yaml.root(), "description", "")});
  }
  return entries;
}

}  // namespace lineservo::apps
