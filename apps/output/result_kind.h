#pragma once

#include <filesystem>
#include <string>

namespace lineservo::apps {

/// Results that have names in common with those of another kind: one folder has room for one kind.
enum class ResultKind { flight, comparison, recording };

/// Throws InputError, for the option that named the folder, when it holds results of another kind: some would
/// be replaced and others stay, and the folder would tell of two runs.
void refuse_other_kinds(const std::filesystem::path& folder, ResultKind kind, const std::string& option);

}  // namespace lineservo::apps
