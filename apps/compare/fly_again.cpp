#include "apps/compare/fly_again.h"

#include <fmt/format.h>

#include <cmath>

#include "apps/config/program_name.h"
#include "apps/output/shell_word.h"

namespace lineservo::apps {

std::string fly_again(const Entry& entry, const std::string& instruction, std::uint64_t seed) {
  std::string command =
      fmt::format("{} fly {} --controller {} --layout {} --conditions {}", for_shell(program_name()),
                  for_shell(instruction), for_shell(entry.controller), for_shell(entry.layout),
                  for_shell(entry.request.conditions));
  if (!std::isnan(entry.speed_m_s)) command += fmt::format(" --speed {}", entry.speed_m_s);
  command += fmt::format(" --seed {}", seed);
  if (entry.tuned) command += " --tuned";
  for (const std::string& assignment : entry.overrides) command += " --set " + for_shell(assignment);
  return command;
}

}  // namespace lineservo::apps
