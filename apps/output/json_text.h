#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace lineservo::apps {

/// JSON as text, on one line or with an indent. Names of files are bytes: what is not UTF-8 in them is
/// replaced.
inline std::string json_text(const nlohmann::ordered_json& json, int indent = -1) {
  return json.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace lineservo::apps
