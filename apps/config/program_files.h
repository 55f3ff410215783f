#pragma once

#include <filesystem>
#include <initializer_list>
#include <optional>

namespace lineservo::apps {

/// A file or folder that comes with the program: the first of the places that there is, looked for upward
/// from the folders in which the program finds its modules (its run path), nearest first. So every program
/// that is linked to an installation has the files of that installation.
std::optional<std::filesystem::path> find_program_file(std::initializer_list<std::filesystem::path> places);

}  // namespace lineservo::apps
