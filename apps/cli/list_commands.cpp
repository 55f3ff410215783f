#include "apps/cli/list_commands.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "apps/config/data_folder.h"
#include "servo/law/controllers.h"

namespace lineservo::apps {
namespace {

void print_data(DataKind kind) {
  for (const DataEntry& entry : list_data(kind)) fmt::print("{:<16} {}\n", entry.name, entry.description);
}

void print_controllers() {
  for (const servo::Controller& c : servo::controllers()) fmt::print("{:<16} {}\n", c.name, c.summary);
}

}  // namespace

void add_list_commands(CLI::App& app) {
  app.add_subcommand("layouts", "list the floors that ship")->callback([] { print_data(DataKind::layout); });
  app.add_subcommand("missions", "list the missions that ship")->callback([] {
    print_data(DataKind::mission);
  });
  app.add_subcommand("controllers", "list the laws")->callback(print_controllers);
  app.add_subcommand("conditions", "list the conditions that ship")->callback([] {
    print_data(DataKind::conditions);
  });
}

}  // namespace lineservo::apps
