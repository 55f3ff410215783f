#include "apps/output/result_folder.h"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "apps/config/input_error.h"

namespace lineservo::apps {

namespace fs = std::filesystem;

namespace {

/// Unlike that of any other writer, in this process or another.
std::string own_suffix() {
  static std::atomic<int> writers = 0;
  return fmt::format(".part-{}-{}", ::getpid(), ++writers);
}

}  // namespace

ResultFolder::ResultFolder(const fs::path& folder) : folder_(folder), suffix_(own_suffix()) {
  std::error_code error;
  fs::create_directories(folder_, error);
  if (error) throw InputError(fmt::format("--out {}: cannot be made: {}", folder_.string(), error.message()));
  if (::access(folder_.c_str(), W_OK | X_OK) != 0 || !fs::is_directory(folder_)) {
    throw InputError(fmt::format("--out {}: is not a folder that can be written to", folder_.string()));
  }
}

ResultFolder::~ResultFolder() {
  std::error_code ignored;
  for (const std::string& name : names_) fs::remove(aside(name), ignored);
}

fs::path ResultFolder::aside(const std::string& name) const {
  return folder_ / (name + suffix_);
}

void ResultFolder::write(const std::string& name, const std::string& content) {
  names_.push_back(name);
  errno = 0;
  std::ofstream file(aside(name), std::ios::binary);
  file << content;
  file.close();
  if (!file) {
    throw InputError(
        fmt::format("{}: cannot be written: {}", (folder_ / name).string(), std::strerror(errno)));
  }
}

void ResultFolder::publish() {
  for (const std::string& name : names_) {  // before the first is renamed: all or nothing
    std::error_code error;
    if (fs::is_directory(folder_ / name, error))
      throw InputError(fmt::format("{}: cannot be written: it is a folder", (folder_ / name).string()));
  }
  for (const std::string& name : names_) {
    std::error_code error;
    fs::rename(aside(name), folder_ / name, error);
    if (error)
      throw InputError(fmt::format("{}: cannot be written: {}", (folder_ / name).string(), error.message()));
  }
  names_.clear();
}

}  // namespace lineservo::apps
