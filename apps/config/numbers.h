#pragma once

#include <charconv>
#include <optional>
#include <string>

namespace lineservo::apps {

/// The whole text as a number within bounds; none for anything else: no text, text behind it, out of range,
/// not a number.
template <typename Number>
std::optional<Number> parse_number(const std::string& text, Number low, Number high) {
  Number value{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end || !(value >= low && value <= high)) return std::nullopt;
  return value;
}

}  // namespace lineservo::apps
