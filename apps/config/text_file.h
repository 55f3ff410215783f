#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace lineservo::apps {

/// Well-formed UTF-8 (Unicode 15, table 3-7): no overlong forms, no surrogates.
bool is_utf8(std::string_view text);

/// The text of a file that a user wrote. Throws InputError when it is a folder, cannot be read, is longer
/// than 1 MiB or is not UTF-8.
std::string read_text_file(const std::filesystem::path& file);

/// All bytes of a file of any size. Throws InputError when it is no file or cannot be read.
std::string read_bytes(const std::filesystem::path& file);

}  // namespace lineservo::apps
