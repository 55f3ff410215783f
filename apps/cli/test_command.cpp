#include "apps/cli/test_command.h"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "apps/config/input_error.h"

namespace lineservo::apps {
namespace {

namespace fs = std::filesystem;

/// Whose apps/ the program is in.
fs::path build_folder() {
  const fs::path folder = fs::read_symlink("/proc/self/exe").parent_path().parent_path();
  if (fs::exists(folder / "CTestTestfile.cmake")) return folder;
  throw InputError("test: this program is not in a build folder; run ./lineservo test in the source folder");
}

/// Does not return when it succeeds: the test runner takes over the process.
[[noreturn]] void run_ctest() {
  const std::string folder = build_folder().string();
  ::execlp("ctest", "ctest", "--test-dir", folder.c_str(), "--output-on-failure", "-j", "2", nullptr);
  throw InputError(std::string("test: ctest cannot be run: ") + std::strerror(errno));
}

}  // namespace

void add_test_command(CLI::App& app) {
  app.add_subcommand("test", "build (through ./lineservo) and run the test suite")->callback(run_ctest);
}

}  // namespace lineservo::apps
