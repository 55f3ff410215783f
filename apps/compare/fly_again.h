#pragma once

#include <cstdint>
#include <string>

#include "apps/compare/comparison.h"

namespace lineservo::apps {

/// The command line that flies one flight of a comparison by itself, for a shell.
std::string fly_again(const Entry& entry, const std::string& instruction, std::uint64_t seed);

}  // namespace lineservo::apps
