#include "apps/cli/evaluate_command.h"

#include <CLI/CLI.hpp>

#include "apps/cli/evaluate_faults_command.h"
#include "apps/cli/evaluate_junctions_command.h"
#include "apps/cli/evaluate_lines_command.h"

namespace lineservo::apps {

void add_evaluate_command(CLI::App& app, int& exit_code) {
  CLI::App* group = app.add_subcommand(
      "evaluate", "accuracy tables on generated frames with exact ground truth, and flights with faults");
  group->require_subcommand(1);
  add_evaluate_lines_command(*group, exit_code);
  add_evaluate_junctions_command(*group, exit_code);
  add_evaluate_faults_command(*group, exit_code);
}

}  // namespace lineservo::apps
