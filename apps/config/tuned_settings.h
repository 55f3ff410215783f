#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "apps/config/flight_request.h"

namespace lineservo::apps {

/// The tuned parameters of a controller that ship, or none.
std::optional<std::filesystem::path> tuned_file(const std::string& controller);

/// Whether a setting is a parameter of a controller's own: servo.CONTROLLER.*, and for those that dock on
/// nodes servo.dock.*.
bool is_law_key(const std::string& controller, const std::string& key);

/// Puts a file of tuned parameters over those of the request. Throws InputError for a key that is not the
/// controller's own, or a value that is not allowed.
void apply_tuned(FlightRequest& request, const std::filesystem::path& file);

/// The same with the file that ships for the request's controller. Throws InputError, behind the `option`
/// that asked for it, when there is none.
void apply_shipped_tuned(FlightRequest& request, const std::string& option);

}  // namespace lineservo::apps
