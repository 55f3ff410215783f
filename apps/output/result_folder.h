#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lineservo::apps {

/// Files that appear whole or not at all: each is written aside and renamed at the end. The one that is
/// written last is the seal of its set: at publishing an earlier one goes before anything else changes and
/// the new one comes when all else is there, so that where it stands the files beside it are of the same run.
/// Of several that publish into one folder each waits for the other.
class ResultFolder {
 public:
  /// Makes the folder when it is not there, and proves that it can be written to and that the names of the
  /// results are free or files': so that nothing is flown for results that have no place. Throws InputError,
  /// which names the option that named the folder.
  explicit ResultFolder(const std::filesystem::path& folder, const std::vector<std::string>& results = {},
                        const std::string& option = "--out");
  ~ResultFolder();
  ResultFolder(const ResultFolder&) = delete;
  ResultFolder& operator=(const ResultFolder&) = delete;

  const std::filesystem::path& path() const { return folder_; }

  /// Throws InputError unless the name is free or a file's, which may be replaced: a device, a folder or a
  /// link may not.
  void check(const std::string& name) const;
  /// Writes a file aside. Throws InputError (disk full, no permission, a name that is not free).
  void write(const std::string& name, const std::string& content);
  /// Where someone else is to write a file of this name, aside; with the same ending, for those who go by it.
  /// Throws InputError as check() does, and when a file of the name is there without `owner`, a file of the
  /// earlier set, beside it.
  std::filesystem::path reserve(const std::string& name, const std::string& owner = {});
  /// What was reserved or written under this name goes, and an earlier file of the name stays.
  void give_up(const std::string& name);
  /// Begins a folder of results, aside. One of this name may stand there already when `owner`, a file of the
  /// earlier set, stands beside it and all that it holds are files numbered as numbered() does with this
  /// ending: it is replaced. Else throws InputError.
  void begin_folder(const std::string& name, const std::string& ending, const std::string& owner);
  /// Writes a file of the folder begun. Throws InputError.
  void write_numbered(std::size_t number, const std::string& content);
  /// An earlier set's folder, told as by begin_folder(): it goes when this set is published. Others stay.
  void leave_out_folder(const std::string& name, const std::string& ending, const std::string& owner);
  /// A file of an earlier set that this one does not have: it goes when this one is published.
  void leave_out(const std::string& name) { left_out_.push_back(name); }
  /// The same when `owner`, a file of the earlier set, stands beside it. Others stay.
  void leave_out(const std::string& name, const std::string& owner);
  /// Renames everything written to its final name: the seal after all, the folder begun just before it.
  void publish();

 private:
  std::filesystem::path aside(const std::string& name) const;
  void put(const std::filesystem::path& file, const std::filesystem::path& name,
           const std::string& content) const;
  void remove(const std::string& name) const;
  void remove_folder(const std::string& name) const;
  void rename(const std::string& name) const;

  std::filesystem::path folder_;
  std::string suffix_;
  std::vector<std::string> names_, left_out_;
  std::string numbered_, ending_;  ///< the folder begun, and its files' ending; none: empty
  std::vector<std::string> left_out_folders_;
};

/// 000012.png for 12 and .png.
std::string numbered(std::size_t number, const std::string& ending);

}  // namespace lineservo::apps
