#include "apps/config/conditions_range.h"

#include <fmt/format.h>

#include <map>

#include "apps/config/input_error.h"
#include "apps/config/settings_table.h"
#include "vehicle/random.h"

namespace lineservo::apps {
namespace {

constexpr std::uint64_t kConditionsStream = 1005;  // of the flight's seed

std::string group_of(const std::string& key) {
  return key.substr(0, key.find('.'));
}

/// Settings of what the vehicle does about its conditions, which are not conditions themselves: those made
/// for the harder ones are taken throughout.
bool is_the_vehicles_answer(const std::string& group) {
  return group == "features" || group == "servo" || group == "executive";
}

std::string between(const Setting& from, const Setting& to, double share) {
  if (!from.range || !to.range) return share < 0.5 ? from.get() : to.get();
  const double a = std::stod(from.get()), b = std::stod(to.get());
  return fmt::format("{}", a + share * (b - a));
}

}  // namespace

std::optional<ConditionsRange> conditions_range(const std::string& text) {
  for (std::size_t at = text.find("..", 1); at != std::string::npos; at = text.find("..", at + 2)) {
    const std::string from = text.substr(0, at), to = text.substr(at + 2);
    const bool is_path = from.ends_with('/') || to.starts_with('/');
    if (is_path || to.empty()) continue;
    if (conditions_range(to))
      throw InputError(fmt::format(
          "--conditions {}: are more than two; allowed: one, or two with .. between, such as paper..harsh",
          text));
    return ConditionsRange{from, to};
  }
  return std::nullopt;
}

void draw_conditions(FlightRequest& request, const ConditionsRange& range) {
  FlightRequest from = request, to = request;
  apply_conditions(from, range.from);
  apply_conditions(to, range.to);
  SettingsTable table(request.settings);
  const SettingsTable low(from.settings), high(to.settings);
  vehicle::Random random(request.seed, kConditionsStream);
  const double share = random.uniform();
  std::map<std::string, bool> is_on;
  for (std::size_t k = 0; k < table.all().size(); ++k) {
    const Setting &a = low.all()[k], &b = high.all()[k];
    if (a.get() == b.get() || is_the_vehicles_answer(group_of(a.key))) {
      table.all()[k].set(b.get());
      continue;
    }
    const auto [group, is_new] = is_on.try_emplace(group_of(a.key), false);
    if (is_new) group->second = random.uniform() < 0.5;
    table.all()[k].set(group->second ? between(a, b, share) : a.get());
  }
}

}  // namespace lineservo::apps
