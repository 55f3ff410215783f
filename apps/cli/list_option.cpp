#include "apps/cli/list_option.h"

#include <CLI/CLI.hpp>
#include <limits>

#include "apps/cli/repeats.h"
#include "apps/config/input_error.h"
#include "apps/config/numbers.h"

namespace lineservo::apps {
namespace {

std::vector<std::string> items_of(const std::string& option, const std::vector<std::string>& words) {
  std::vector<std::string> items;
  for (const std::string& word : words) {
    for (std::size_t begin = 0, end = 0; end != word.npos; begin = end + 1) {
      end = word.find(',', begin);
      items.push_back(word.substr(begin, end - begin));
      if (items.back().empty())
        throw InputError(fmt::format(
            "{} '{}': an item is empty; allowed are words separated by single commas", option, word));
    }
  }
  return items;
}

double number_of(const std::string& option, const std::string& text) {
  constexpr double kLargest = std::numeric_limits<double>::max();
  const std::optional<double> number = parse_number(text, -kLargest, kLargest);
  if (!number) throw InputError(fmt::format("{} '{}': must be a number", option, text));
  return *number;
}

}  // namespace

CLI::Option* add_list_option(CLI::App& command, const std::string& name, std::vector<std::string>& items,
                             const std::string& help) {
  const auto take = [&items, name](const std::vector<std::string>& words) {
    items = items_of(name, words);
    refuse_repeats(name, items);
  };
  return command.add_option_function<std::vector<std::string>>(name, take, help)->type_name("A,B,...");
}

CLI::Option* add_list_option(CLI::App& command, const std::string& name, std::vector<double>& numbers,
                             const std::string& help) {
  const auto take = [&numbers, name](const std::vector<std::string>& words) {
    numbers.clear();
    for (const std::string& item : items_of(name, words)) numbers.push_back(number_of(name, item));
    refuse_repeats(name, numbers);
  };
  return command.add_option_function<std::vector<std::string>>(name, take, help)->type_name("N,N,...");
}

}  // namespace lineservo::apps
