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

/// Holds nothing but files that are named as numbered() does.
bool is_numbered(const fs::path& folder, const std::string& ending) {
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const std::string stem = entry.path().stem().string();
    const bool is_number = stem.size() >= 6 && stem.find_first_not_of("0123456789") == stem.npos;
    if (!is_number || entry.path().extension() != ending || !entry.is_regular_file()) return false;
  }
  return !error;
}

}  // namespace

std::string numbered(std::size_t number, const std::string& ending) {
  return fmt::format("{:06}{}", number, ending);
}

ResultFolder::ResultFolder(const fs::path& folder, const std::vector<std::string>& results,
                           const std::string& option)
    : folder_(folder), suffix_(own_suffix()) {
  std::error_code error;
  fs::create_directories(folder_, error);
  if (error)
    throw InputError(fmt::format("{} {}: cannot be made: {}", option, folder_.string(), error.message()));
  if (::access(folder_.c_str(), W_OK | X_OK) != 0 || !fs::is_directory(folder_)) {
    throw InputError(fmt::format("{} {}: is not a folder that can be written to", option, folder_.string()));
  }
  for (const std::string& name : results) check(name);
}

ResultFolder::~ResultFolder() {
  std::error_code ignored;
  for (const std::string& name : names_) fs::remove(aside(name), ignored);
  if (!numbered_.empty()) fs::remove_all(aside(numbered_), ignored);
}

fs::path ResultFolder::aside(const std::string& name) const {
  return folder_ / (name + suffix_ + fs::path(name).extension().string());
}

void ResultFolder::check(const std::string& name) const {
  std::error_code error;
  const fs::file_status status = fs::symlink_status(folder_ / name, error);
  const char* const why = name.empty() || fs::is_directory(status)             ? "it is a folder"
                          : fs::is_symlink(status)                             ? "it is a link"
                          : fs::exists(status) && !fs::is_regular_file(status) ? "it is not a file"
                                                                               : nullptr;
  if (why) throw InputError(fmt::format("{}: cannot be written: {}", (folder_ / name).string(), why));
}

void ResultFolder::write(const std::string& name, const std::string& content) {
  put(reserve(name), folder_ / name, content);
}

fs::path ResultFolder::reserve(const std::string& name, const std::string& owner) {
  check(name);
  std::error_code error;
  if (!owner.empty() && fs::exists(folder_ / name, error) && !fs::exists(folder_ / owner, error))
    throw InputError(fmt::format("{}: is there already, and not from an earlier run: it is not replaced",
                                 (folder_ / name).string()));
  names_.push_back(name);
  return aside(name);
}

void ResultFolder::give_up(const std::string& name) {
  std::error_code ignored;
  fs::remove(aside(name), ignored);
  std::erase(names_, name);
}

void ResultFolder::leave_out(const std::string& name, const std::string& owner) {
  std::error_code error;
  if (fs::exists(folder_ / owner, error)) leave_out(name);
}

void ResultFolder::put(const fs::path& file, const fs::path& name, const std::string& content) const {
  errno = 0;
  std::ofstream stream(file, std::ios::binary);
  stream << content;
  stream.close();
  if (!stream)
    throw InputError(fmt::format("{}: cannot be written: {}", name.string(), std::strerror(errno)));
}

void ResultFolder::begin_folder(const std::string& name, const std::string& ending,
                                const std::string& owner) {
  const fs::path folder = folder_ / name;
  std::error_code error;
  const bool is_free = !fs::exists(fs::symlink_status(folder, error));
  const bool is_earlier = fs::exists(folder_ / owner, error) && is_numbered(folder, ending);
  if (!is_free && !is_earlier)
    throw InputError(fmt::format("{}: is there already, and not from an earlier run: it is not replaced",
                                 folder.string()));
  fs::create_directory(aside(name), error);
  if (error) throw InputError(fmt::format("{}: cannot be made: {}", folder.string(), error.message()));
  numbered_ = name;
  ending_ = ending;
}

void ResultFolder::write_numbered(std::size_t number, const std::string& content) {
  const std::string file = numbered(number, ending_);
  put(aside(numbered_) / file, folder_ / numbered_ / file, content);
}

void ResultFolder::leave_out_folder(const std::string& name, const std::string& ending,
                                    const std::string& owner) {
  std::error_code error;
  if (fs::exists(folder_ / owner, error) && is_numbered(folder_ / name, ending))
    left_out_folders_.push_back(name);
}

void ResultFolder::publish() {
  const FolderLock lock(folder_);
  for (const std::string& name : names_) check(name);  // before the first is renamed: all or nothing
  const bool is_set = names_.size() + left_out_.size() + left_out_folders_.size() > 1 || !numbered_.empty();
  if (is_set) remove(names_.back());
  for (const std::string& name : left_out_folders_) remove_folder(name);
  for (const std::string& name : left_out_) remove(name);
  for (std::size_t k = 0; k + 1 < names_.size(); ++k) rename(names_[k]);
  if (!numbered_.empty()) {
    remove_folder(numbered_);
    rename(numbered_);
    numbered_.clear();
  }
  rename(names_.back());
  names_.clear();
}

void ResultFolder::rename(const std::string& name) const {
  std::error_code error;
  fs::rename(aside(name), folder_ / name, error);
  if (error)
    throw InputError(fmt::format("{}: cannot be written: {}", (folder_ / name).string(), error.message()));
}

void ResultFolder::remove(const std::string& name) const {
  std::error_code error;
  fs::remove(folder_ / name, error);
  if (error)
    throw InputError(fmt::format("{}: cannot be replaced: {}", (folder_ / name).string(), error.message()));
}

void ResultFolder::remove_folder(const std::string& name) const {
  std::error_code error;
  fs::remove_all(folder_ / name, error);
  if (error)
    throw InputError(fmt::format("{}: cannot be replaced: {}", (folder_ / name).string(), error.message()));
}

}  // namespace lineservo::apps
