#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lineservo::apps {

/// The name that was asked for, or with none asked for the only one. Throws InputError when there is no such
/// name, or several to choose from.
std::string one_of(const std::vector<std::string>& names, const std::string& asked,
                   const std::filesystem::path& file);

}  // namespace lineservo::apps
