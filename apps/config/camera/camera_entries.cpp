#include "apps/config/camera/camera_entries.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "apps/config/input_error.h"
#include "apps/config/numbers.h"

namespace lineservo::apps {
namespace {

std::optional<double> finite_number(const std::string& word) {
  constexpr double kLargest = std::numeric_limits<double>::max();
  return parse_number(word.starts_with('+') ? word.substr(1) : word, -kLargest, kLargest);
}

}  // namespace

CameraEntries::CameraEntries(std::filesystem::path file, int line) : file_(std::move(file)), line_(line) {}

void CameraEntries::add(CameraEntry entry) {
  if (has({entry.key})) fail(entry.line, "key '" + entry.key + "' twice");
  entries_.push_back(std::move(entry));
}

const CameraEntry* CameraEntries::find(const Spellings& keys) const {
  const auto found = std::find_if(entries_.begin(), entries_.end(), [&keys](const CameraEntry& entry) {
    return std::find(keys.begin(), keys.end(), entry.key) != keys.end();
  });
  return found == entries_.end() ? nullptr : &*found;
}

const CameraEntry& CameraEntries::at(const Spellings& keys) const {
  const CameraEntry* entry = find(keys);
  if (entry == nullptr) fail(line_, "key '" + keys.front() + "' is missing");
  return *entry;
}

std::string CameraEntries::word(const Spellings& keys) const {
  const CameraEntry& entry = at(keys);
  if (entry.words.size() != 1) fail(entry, "must be a word");
  return entry.words.front();
}

double CameraEntries::number(const Spellings& keys) const {
  const CameraEntry& entry = at(keys);
  if (entry.words.size() != 1) fail(entry, "must be a number");
  return numbers(keys).front();
}

std::vector<double> CameraEntries::numbers(const Spellings& keys) const {
  const CameraEntry& entry = at(keys);
  std::vector<double> values;
  for (const std::string& word : entry.words) {
    const std::optional<double> value = finite_number(word);
    if (!value) fail(entry, "'" + word + "' must be a finite number");
    values.push_back(*value);
  }
  return values;
}

std::vector<int> CameraEntries::sides_px(const Spellings& keys, std::size_t count) const {
  std::vector<int> sides;
  for (const double side : numbers(keys)) {
    if (side != std::floor(side) || side < 16.0 || side > 16384.0)
      fail(at(keys), "must be whole numbers of 16 to 16384 pixels");
    sides.push_back(static_cast<int>(side));
  }
  if (sides.size() != count) fail(at(keys), fmt::format("must be {} numbers of pixels", count));
  return sides;
}

void CameraEntries::fail(const CameraEntry& at, const std::string& message) const {
  fail(at.line, "key '" + at.key + "': " + message);
}

void CameraEntries::fail(int line, const std::string& message) const {
  throw InputError(fmt::format("{}:{}: {}", file_.string(), line, message));
}

}  // namespace lineservo::apps
