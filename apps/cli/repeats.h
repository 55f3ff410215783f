#pragma once

#include <fmt/format.h>

#include <set>
#include <string>
#include <vector>

#include "apps/config/input_error.h"

namespace lineservo::apps {

/// Throws InputError when a list that was typed has an item twice: it would be flown, and counted, twice.
template <typename Item>
void refuse_repeats(const std::string& option, const std::vector<Item>& items) {
  std::set<Item> seen;
  for (const Item& item : items)
    if (!seen.insert(item).second) throw InputError(fmt::format("{}: '{}' is named twice", option, item));
}

}  // namespace lineservo::apps
