#include "servo/plan/dif.h"

#include <array>
#include <charconv>
#include <optional>
#include <stdexcept>

namespace lineservo::servo {
namespace {

/// Bounds of (i, j) by zone: topology Tab. 1.
struct ZoneRange {
  char zone;
  int i_max, j_max;
};
constexpr int kGridMax = 999;
constexpr std::array<ZoneRange, 4> kZones = {
    {{'a', kGridMax, kGridMax}, {'b', 0, 3}, {'c', 0, 7}, {'d', 0, 0}}};

std::optional<int> whole_number(std::string_view digits) {
  int value = 0;
  const char* end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, value);
  if (digits.empty() || digits.front() == '-' || error != std::errc{} || stop != end) return std::nullopt;
  return value;
}

std::optional<Dif> split(std::string_view text) {
  std::optional<int> i, j;
  if (text.size() == 3) {
    i = whole_number(text.substr(1, 1));
    j = whole_number(text.substr(2, 1));
  } else if (text.size() >= 5 && text[1] == ':') {
    const std::size_t colon = text.find(':', 2);
    if (colon == std::string_view::npos) return std::nullopt;
    i = whole_number(text.substr(2, colon - 2));
    j = whole_number(text.substr(colon + 1));
  }
  if (!i || !j) return std::nullopt;
  return Dif{text[0], *i, *j};
}

bool in_range(const Dif& dif) {
  for (const ZoneRange& range : kZones) {
    if (range.zone == dif.zone) return dif.i <= range.i_max && dif.j <= range.j_max;
  }
  return false;
}

}  // namespace

Dif parse_dif(std::string_view text) {
  const std::optional<Dif> dif = split(text);
  if (!dif || !in_range(*dif)) {
    throw std::invalid_argument(
        "'" + std::string(text) +
        "' is not an instruction: allowed are a and two digits (a13, or a:12:3 beyond ten), "
        "b00 to b03, c00 to c07, d00");
  }
  return *dif;
}

std::string to_string(const Dif& dif) {
  const std::string i = std::to_string(dif.i), j = std::to_string(dif.j);
  if (dif.i < 10 && dif.j < 10) return dif.zone + i + j;
  return std::string(1, dif.zone) + ":" + i + ":" + j;
}

}  // namespace lineservo::servo
