#include "apps/config/camera/one_of.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "apps/config/input_error.h"

namespace lineservo::apps {

std::string one_of(const std::vector<std::string>& names, const std::string& asked,
                   const std::filesystem::path& file) {
  const std::string list = fmt::format("{}", fmt::join(names, ", "));
  if (asked.empty() && names.size() == 1) return names.front();
  if (asked.empty())
    throw InputError(
        fmt::format("{0}: holds the cameras {1}: choose one as {0}#{2}", file.string(), list, names.front()));
  if (std::find(names.begin(), names.end(), asked) == names.end())
    throw InputError(fmt::format("{}: has no camera '{}'; it holds {}", file.string(), asked, list));
  return asked;
}

}  // namespace lineservo::apps
