#include "apps/config/text_file.h"

#include <algorithm>
#include <array>
#include <fstream>

#include "apps/config/input_error.h"

namespace lineservo::apps {
namespace {

constexpr std::size_t kLongest_bytes = std::size_t{1} << 20;

/// Lead bytes from `first` to `last`, the bounds of the byte that follows, and how many bytes follow in all.
struct Utf8Form {
  unsigned char first, last, low, high;
  std::size_t following;
};
constexpr std::array<Utf8Form, 9> kForms = {{{0x00, 0x7F, 0x00, 0x00, 0},
                                             {0xC2, 0xDF, 0x80, 0xBF, 1},
                                             {0xE0, 0xE0, 0xA0, 0xBF, 2},
                                             {0xE1, 0xEC, 0x80, 0xBF, 2},
                                             {0xED, 0xED, 0x80, 0x9F, 2},
                                             {0xEE, 0xEF, 0x80, 0xBF, 2},
                                             {0xF0, 0xF0, 0x90, 0xBF, 3},
                                             {0xF1, 0xF3, 0x80, 0xBF, 3},
                                             {0xF4, 0xF4, 0x80, 0x8F, 3}}};

bool follows(char c, unsigned char low, unsigned char high) {
  const auto byte = static_cast<unsigned char>(c);
  return byte >= low && byte <= high;
}

/// Bytes of the character that the text begins with; 0 when it is none.
std::size_t character_bytes(std::string_view text) {
  for (const Utf8Form& form : kForms) {
    if (!follows(text[0], form.first, form.last)) continue;
    if (text.size() <= form.following) return 0;
    for (std::size_t k = 1; k <= form.following; ++k) {
      const bool is_second = k == 1;
      if (!follows(text[k], is_second ? form.low : 0x80, is_second ? form.high : 0xBF)) return 0;
    }
    return 1 + form.following;
  }
  return 0;
}

void refuse_no_name(const std::filesystem::path& file) {
  if (file.empty()) throw InputError("'': is empty where the name of a file is needed");
}

}  // namespace

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t bytes = character_bytes(text);
    if (bytes == 0) return false;
    text.remove_prefix(bytes);
  }
  return true;
}

std::string read_text_file(const std::filesystem::path& file) {
  refuse_no_name(file);
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored))
    throw InputError(file.string() + ": is a folder, not a file");
  if (std::filesystem::is_fifo(file, ignored)) throw InputError(file.string() + ": is a pipe, not a file");
  std::ifstream stream(file, std::ios::binary);
  std::string text(kLongest_bytes + 1, '\0');
  if (!stream) throw InputError(file.string() + ": cannot be read");
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (stream.bad()) throw InputError(file.string() + ": cannot be read");
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (text.size() > kLongest_bytes) throw InputError(file.string() + ": is longer than 1 MiB");
  if (!is_utf8(text)) throw InputError(file.string() + ": is not UTF-8 text");
  return text;
}

std::string read_bytes(const std::filesystem::path& file) {
  refuse_no_name(file);
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) throw InputError(file.string() + ": not a file");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw InputError(file.string() + ": cannot be read");
  try {
    return {std::istreambuf_iterator<char>(stream), {}};
  } catch (const std::ios_base::failure&) {  // a disk that fails
    throw InputError(file.string() + ": cannot be read");
  }
}

}  // namespace lineservo::apps
