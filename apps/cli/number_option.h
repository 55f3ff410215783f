#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>

#include "apps/config/flight_request.h"
#include "apps/config/input_error.h"
#include "apps/config/numbers.h"

namespace lineservo::apps {

/// An option that takes a whole number within bounds; `value` is its default. Throws InputError for anything
/// else, also for what a conversion would bend: no text, a minus before an unsigned number, an overflow.
inline void add_whole_option(CLI::App& command, const std::string& name, int& value, int low, int high,
                             const std::string& help) {
  const auto take = [&value, name, low, high](const std::string& text) {
    const std::optional<int> number = parse_number(text, low, high);
    if (!number)
      throw InputError(fmt::format("{} '{}': must be a whole number from {} to {}", name, text, low, high));
    value = *number;
  };
  command.add_option_function<std::string>(name, take, fmt::format("{} (default {})", help, value))
      ->type_name("N");
}

inline void add_seed_option(CLI::App& command, std::uint64_t& seed, const std::string& help) {
  const auto take = [&seed](const std::string& text) { seed = read_seed(text, "--seed '" + text + "'"); };
  command.add_option_function<std::string>("--seed", take, fmt::format("{} (default {})", help, seed))
      ->type_name("N");
}

}  // namespace lineservo::apps
