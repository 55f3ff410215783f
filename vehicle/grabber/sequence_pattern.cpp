#include "vehicle/grabber/sequence_pattern.h"

#include <fmt/format.h>

#include <algorithm>

#include "vehicle/grabber/frame_source.h"

namespace lineservo::vehicle {
namespace {

namespace fs = std::filesystem;

constexpr char kDigits[] = "0123456789";
constexpr std::size_t kLongest = 1024;  ///< far below the buffers that the name is printed into

[[noreturn]] void refuse(const std::string& pattern) {
  throw GrabberError(pattern + ": must have one %d or %04d (up to %09d) in the file's name, and no other %");
}

}  // namespace

SequencePattern::SequencePattern(const std::string& pattern) {
  const std::size_t at = pattern.find('%');
  if (at == pattern.npos || pattern.size() > kLongest) refuse(pattern);
  const std::size_t end = pattern.find_first_not_of(kDigits, at + 1);
  if (end == pattern.npos || pattern[end] != 'd') refuse(pattern);
  before_ = pattern.substr(0, at);
  width_ = pattern.substr(at + 1, end - at - 1);
  after_ = pattern.substr(end + 1);
  const bool padded = width_.size() == 2 && width_[0] == '0' && width_[1] != '0';
  if (!(width_.empty() || padded) || after_.find_first_of("%/") != after_.npos) refuse(pattern);
}

std::string SequencePattern::for_long() const {
  return before_ + "%" + width_ + "ld" + after_;
}

std::optional<long> SequencePattern::number_of(const std::string& file_name) const {
  const std::string prefix = fs::path(before_).filename().string();
  if (file_name.size() <= prefix.size() + after_.size() || file_name.rfind(prefix, 0) != 0 ||
      file_name.compare(file_name.size() - after_.size(), after_.size(), after_) != 0)
    return std::nullopt;
  const std::string digits =
      file_name.substr(prefix.size(), file_name.size() - prefix.size() - after_.size());
  if (digits.size() > 9 || digits.find_first_not_of(kDigits) != digits.npos) return std::nullopt;
  const long number = std::stol(digits);
  const int width = width_.empty() ? 0 : width_[1] - '0';
  if (fmt::format("{:0{}}", number, width) != digits) return std::nullopt;  // %d does not print it so
  return number;
}

std::vector<long> SequencePattern::numbers() const {
  const fs::path folder = fs::path(before_).parent_path();
  std::vector<long> list;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder.empty() ? "." : folder, ignored))
    if (const std::optional<long> number = number_of(entry.path().filename().string()))
      list.push_back(*number);
  std::sort(list.begin(), list.end());
  return list;
}

}  // namespace lineservo::vehicle
