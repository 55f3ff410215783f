#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace lineservo::apps {

/// An option that takes a list, its items separated by commas. Throws InputError for an empty item, for one
/// that stands twice (it would be flown, and counted, twice) and, of numbers, for one that is none.
CLI::Option* add_list_option(CLI::App& command, const std::string& name, std::vector<std::string>& items,
                             const std::string& help);
CLI::Option* add_list_option(CLI::App& command, const std::string& name, std::vector<double>& numbers,
                             const std::string& help);

}  // namespace lineservo::apps
