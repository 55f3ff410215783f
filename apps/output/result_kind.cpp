#include "apps/output/result_kind.h"

#include <fmt/format.h>

#include <array>

#include "apps/config/input_error.h"

namespace lineservo::apps {
namespace {

struct KindOfResults {
  ResultKind kind;
  const char* seal;  ///< the file that is written last
  const char* name;
};

/// A flight may hold a recording as well: what is found first counts.
constexpr std::array<KindOfResults, 3> kKinds = {
    {{ResultKind::flight, "summary.json", "a flight"},
     {ResultKind::comparison, "comparison.json", "a comparison"},
     {ResultKind::recording, "recording.json", "watch --record"}}};

const char* name_of(ResultKind kind) {
  for (const KindOfResults& k : kKinds)
    if (k.kind == kind) return k.name;
  return "?";
}

}  // namespace

void refuse_other_kinds(const std::filesystem::path& folder, ResultKind kind, const std::string& option) {
  std::error_code error;
  for (const KindOfResults& there : kKinds) {
    if (!std::filesystem::exists(folder / there.seal, error)) continue;
    if (there.kind == kind) return;
    throw InputError(fmt::format(
        "{} {}: holds the results of {} ({}); allowed: a folder without results, or with those of {}", option,
        folder.string(), there.name, there.seal, name_of(kind)));
  }
}

}  // namespace lineservo::apps
