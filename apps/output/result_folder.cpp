#include "apps/output/result_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
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

/// Held by one at a time, in this process or another; where the file system has no locks, by all.
class FolderLock {
 public:
  explicit FolderLock(const fs::path& folder) : descriptor_(::open(folder.c_str(), O_RDONLY | O_CLOEXEC)) {
    while (::flock(descriptor_, LOCK_EX) != 0 && errno == EINTR) {
    }
  }
  ~FolderLock() { ::close(descriptor_); }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int descriptor_;
};

}  // namespace

ResultFolder::ResultFolder(const fs::path& folder, const std::vector<std::string>& results)
    : folder_(folder), suffix_(own_suffix()) {
  std::error_code error;
  fs::create_directories(folder_, error);
  if (error) throw InputError(fmt::format("--out {}: cannot be made: {}", folder_.string(), error.message()));
  if (::access(folder_.c_str(), W_OK | X_OK) != 0 || !fs::is_directory(folder_)) {
    throw InputError(fmt::format("--out {}: is not a folder that can be written to", folder_.string()));
  }
  for (const std::string& name : results) check(name);
}

ResultFolder::~ResultFolder() {
  std::error_code ignored;
  for (const std::string& name : names_) fs::remove(aside(name), ignored);
}

fs::path ResultFolder::aside(const std::string& name) const {
  return folder_ / (name + suffix_);
}

void ResultFolder::check(const std::string& name) const {
  std::error_code error;
  const fs::file_status status = fs::status(folder_ / name, error);
  if (name.empty() || (fs::exists(status) && !fs::is_regular_file(status)))
    throw InputError(
        fmt::format("{}: cannot be written: {}", (folder_ / name).string(),
                    name.empty() || fs::is_directory(status) ? "it is a folder" : "it is not a file"));
}

void ResultFolder::write(const std::string& name, const std::string& content) {
  check(name);
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
  const FolderLock lock(folder_);
  for (const std::string& name : names_) check(name);  // before the first is renamed: all or nothing
  if (names_.size() + left_out_.size() > 1) remove(names_.back());
  for (const std::string& name : left_out_) remove(name);
  for (const std::string& name : names_) {
    std::error_code error;
    fs::rename(aside(name), folder_ / name, error);
    if (error)
      throw InputError(fmt::format("{}: cannot be written: {}", (folder_ / name).string(), error.message()));
  }
  names_.clear();
}

void ResultFolder::remove(const std::string& name) const {
  std::error_code error;
  fs::remove(folder_ / name, error);
  if (error)
    throw InputError(fmt::format("{}: cannot be replaced: {}", (folder_ / name).string(), error.message()));
}

}  // namespace lineservo::apps
