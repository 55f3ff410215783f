#include "apps/config/tuned_settings.h"

#include <fmt/format.h>

#include "apps/config/data_folder.h"
#include "apps/config/input_error.h"
#include "apps/config/settings_table.h"
#include "apps/config/yaml_reader.h"

namespace lineservo::apps {

std::optional<std::filesystem::path> tuned_file(const std::string& controller) {
  return shipped_file(std::filesystem::path("tuned") / (controller + ".yaml"));
}

bool is_law_key(const std::string& controller, const std::string& key) {
  if (key.starts_with("servo." + controller + ".")) return true;
  return servo::find_controller(controller).traits.servos_on_node && key.starts_with("servo.dock.");
}

void apply_tuned(FlightRequest& request, const std::filesystem::path& file) {
  const YamlReader yaml(file);
  SettingsTable table(request.settings);
  for (const YamlEntry& entry : yaml.scalars()) {
    const std::string where = fmt::format("{}:{}", file.string(), entry.line);
    if (!is_law_key(request.controller, entry.key)) {
      throw InputError(
          fmt::format("{}: '{}' is no parameter of {}; tuned files hold servo.{}.* alone, and "
                      "servo.dock.* of laws that dock",
                      where, entry.key, request.controller, request.controller));
    }
    table.set(entry.key, entry.text, where);
  }
}

void apply_shipped_tuned(FlightRequest& request, const std::string& option) {
  servo::find_controller(request.controller);
  const auto file = tuned_file(request.controller);
  if (!file) {
    throw InputError(fmt::format("{}: no tuned parameters of {} ship (tuned/{}.yaml in the data folder)",
                                 option, request.controller, request.controller));
  }
  apply_tuned(request, *file);
}

}  // namespace lineservo::apps
