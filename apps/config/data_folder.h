#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace lineservo::apps {

/// A kind of file that ships with the program.
enum class DataKind { layout, conditions, mission };

/// The file that a user means: a name that ships ("warehouse") or a path to a file of one's own; of missions,
/// which go by their file names ("stock-take.yaml"), one's own goes first. Throws InputError, with the names
/// that there are, for anything else.
std::filesystem::path find_data(DataKind kind, const std::string& name_or_path);

/// Whether a name is that of something that ships.
bool is_shipped(DataKind kind, const std::string& name);

/// The text of a file that ships, by its path in the data folder ("models/yellow.yaml"). Throws InputError.
std::string shipped_text(const std::filesystem::path& file);
/// Where such a file is, or none when it does not ship.
std::optional<std::filesystem::path> shipped_file(const std::filesystem::path& file);

/// What ships of a kind: name and description, in order of names.
struct DataEntry {
  std::string name;
  std::string description;
};
std::vector<DataEntry> list_data(DataKind kind);

}  // namespace lineservo::apps
