#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lineservo::apps {

/// Files that appear whole or not at all: each is written aside and renamed at the end.
class ResultFolder {
 public:
  /// Makes the folder when it is not there, and proves that it can be written to. Throws InputError.
  explicit ResultFolder(const std::filesystem::path& folder);
  ~ResultFolder();
  ResultFolder(const ResultFolder&) = delete;
  ResultFolder& operator=(const ResultFolder&) = delete;

  /// Writes a file aside. Throws InputError (disk full, no permission).
  void write(const std::string& name, const std::string& content);
  /// Renames everything written to its final name.
  void publish();

 private:
  std::filesystem::path aside(const std::string& name) const;

  std::filesystem::path folder_;
  std::string suffix_;
  std::vector<std::string> names_;
};

}  // namespace lineservo::apps
