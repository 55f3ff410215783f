#include "vehicle/grabber/source_name.h"

#include <algorithm>
#include <filesystem>

namespace lineservo::vehicle {
namespace {

bool is_number(const std::string& name) {
  return !name.empty() && name.size() <= 3 && name.find_first_not_of("0123456789") == name.npos;
}

}  // namespace

SourceKind source_kind(const std::string& name) {
  std::error_code ignored;
  if (name.find(" ! ") != name.npos) return SourceKind::pipeline;
  if (name.find("://") != name.npos) return SourceKind::stream;
  const std::filesystem::file_status status = std::filesystem::status(name, ignored);
  if (std::filesystem::is_directory(status)) return SourceKind::folder;
  if (std::filesystem::is_regular_file(status)) return SourceKind::video;
  if (std::filesystem::is_character_file(status) || name.rfind("/dev/", 0) == 0 || is_number(name))
    return SourceKind::device;
  return name.find('%') != name.npos ? SourceKind::sequence : SourceKind::video;
}

std::string device_path(const std::string& name) {
  return is_number(name) ? "/dev/video" + name : name;
}

}  // namespace lineservo::vehicle
