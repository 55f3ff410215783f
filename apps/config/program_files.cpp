#include "apps/config/program_files.h"

#include <dlfcn.h>
#include <link.h>

#include <cstddef>
#include <vector>

namespace lineservo::apps {
namespace {

namespace fs = std::filesystem;

/// Where dlopen() looks for what this program asks for, in its order.
std::vector<fs::path> module_folders() {
  void* const program = ::dlopen(nullptr, RTLD_NOW);
  Dl_serinfo size;
  if (program == nullptr || ::dlinfo(program, RTLD_DI_SERINFOSIZE, &size) != 0) return {};
  std::vector<std::max_align_t> memory(size.dls_size / sizeof(std::max_align_t) + 1);
  auto* const info = reinterpret_cast<Dl_serinfo*>(memory.data());
  if (::dlinfo(program, RTLD_DI_SERINFOSIZE, info) != 0 || ::dlinfo(program, RTLD_DI_SERINFO, info) != 0)
    return {};
  std::vector<fs::path> folders;
  for (unsigned i = 0; i < info->dls_cnt; ++i) folders.emplace_back(info->dls_serpath[i].dls_name);
  return folders;
}

}  // namespace

std::optional<fs::path> find_program_file(std::initializer_list<fs::path> places) {
  std::error_code error;
  for (const fs::path& folder : module_folders()) {
    fs::path at = folder.lexically_normal();
    for (; !at.empty() && at != at.root_path(); at = at.parent_path()) {
      for (const fs::path& place : places) {
        if (fs::exists(at / place, error)) return at / place;
      }
    }
  }
  return std::nullopt;
}

}  // namespace lineservo::apps
