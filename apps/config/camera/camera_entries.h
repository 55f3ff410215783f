#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lineservo::apps {

/// What a camera file says at one key, word by word, and where.
struct CameraEntry {
  std::string key;
  std::vector<std::string> words;
  int line = 0;
};

/// The ways in which programs spell one key; complaints use the first.
using Spellings = std::vector<std::string>;

/// The entries of one camera, whatever the format of its file. Every complaint is an InputError that names
/// file, line and key.
class CameraEntries {
 public:
  /// `line`: where the camera begins, for complaints of what is missing.
  CameraEntries(std::filesystem::path file, int line);

  /// Throws when the key is there already.
  void add(CameraEntry entry);

  bool has(const Spellings& keys) const { return find(keys) != nullptr; }
  /// Null when the key is absent.
  const CameraEntry* find(const Spellings& keys) const;
  /// Throws when the key is absent.
  const CameraEntry& at(const Spellings& keys) const;

  std::string word(const Spellings& keys) const;
  double number(const Spellings& keys) const;
  /// Finite numbers, as many as are written there.
  std::vector<double> numbers(const Spellings& keys) const;
  /// Sides of an image that features::CameraModel takes, as many as `count`.
  std::vector<int> sides_px(const Spellings& keys, std::size_t count) const;
  int side_px(const Spellings& keys) const { return sides_px(keys, 1).front(); }

  [[noreturn]] void fail(const CameraEntry& at, const std::string& message) const;

 private:
  [[noreturn]] void fail(int line, const std::string& message) const;

  std::filesystem::path file_;
  int line_;
  std::vector<CameraEntry> entries_;
};

}  // namespace lineservo::apps
