#pragma once

#include <fmt/format.h>

#include <string>

#include "apps/output/command_row.h"

namespace lineservo::apps {

/// The header's columns of a controller's commands, each behind a comma: ",ibvs.forward_m_s,…".
inline std::string command_columns(const std::string& controller) {
  std::string columns;
  for (const char* name : kCommandColumns) columns += fmt::format(",{}.{}", controller, name);
  return columns;
}

/// Its cells; what the command does not set is nan.
inline std::string command_cells(const CommandRow& command) {
  std::string cells;
  for (const double value : command) cells += fmt::format(",{:.6f}", value);
  return cells;
}

}  // namespace lineservo::apps
