#pragma once

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "tests/apps/test_files.h"

namespace lineservo::apps {

/// How the built program ended, run as a user does.
struct Ran {
  int exit_code = -1;  ///< 128 and the signal's number when a signal ended it
  std::string out, err;
};

class ProgramTest : public ::testing::Test {
 protected:
  /// `largest_file`: bytes that a file may grow to, as on a disk that is full; 0 for no such limit.
  Ran run(const std::vector<std::string>& arguments, rlim_t largest_file = 0) const {
    return run_to(temp_.path() / "stdout", std::filesystem::current_path(), arguments, largest_file);
  }
  Ran run_in(const std::filesystem::path& folder, const std::vector<std::string>& arguments) const {
    return run_to(temp_.path() / "stdout", folder, arguments, 0);
  }
  Ran run_to(const std::filesystem::path& out, const std::filesystem::path& folder,
             const std::vector<std::string>& arguments, rlim_t largest_file) const {
    return ended(start(out, folder, arguments, largest_file), out);
  }
  /// Ctrl-C, or another signal, once `begun` says so, within 20 s.
  Ran run_and_interrupt(const std::vector<std::string>& arguments, const std::function<bool()>& begun,
                        int signal = SIGINT) const {
    return run_beside(arguments, [&begun, signal](pid_t child) {
      for (int k = 0; k < 4000 && !begun(); ++k) std::this_thread::sleep_for(std::chrono::milliseconds(5));
      EXPECT_TRUE(begun());
      ::kill(child, signal);
    });
  }
  /// Does something while it runs.
  Ran run_beside(const std::vector<std::string>& arguments, const std::function<void(pid_t)>& act) const {
    const std::filesystem::path out = temp_.path() / "stdout";
    const pid_t child = start(out, std::filesystem::current_path(), arguments, 0);
    act(child);
    return ended(child, out);
  }
  /// Bad input: exit code 2, one line on stderr, nothing on stdout. Returns the line.
  std::string refusal(const std::vector<std::string>& arguments) const {
    const Ran ran = run(arguments);
    EXPECT_EQ(ran.exit_code, 2) << ran.err;
    EXPECT_EQ(ran.out, "");
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
    EXPECT_THAT(ran.err, ::testing::AllOf(::testing::StartsWith("lineservo: "), ::testing::EndsWith("\n")));
    return ran.err;
  }
  std::filesystem::path path(const std::string& name) const { return temp_.path() / name; }

  /// A flight of three seconds' wall time at most, to the end of a line of 1.2 m.
  std::vector<std::string> short_flight(const std::vector<std::string>& more = {}) const {
    const std::filesystem::path floor =
        temp_.write("short.yaml",
                    "name: short\n"
                    "nodes: [{name: p, x_m: 0, y_m: 0}, {name: q, x_m: 1.2, y_m: 0}]\n"
                    "edges: [{from: p, to: q, width_m: 0.1}]\n"
                    "start: {node: p}\n");
    std::vector<std::string> arguments = {"fly",          "node:q",       "--layout",
                                          floor.string(), "--conditions", "ideal"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }

  const testing::TempFolder temp_;

 private:
  pid_t start(const std::filesystem::path& out, const std::filesystem::path& folder,
              const std::vector<std::string>& arguments, rlim_t largest_file) const {
    const pid_t child = ::fork();
    if (child != 0) return child;
    if (::chdir(folder.c_str()) != 0) ::_exit(126);
    become_program(arguments, out, temp_.path() / "stderr", largest_file);
  }
  Ran ended(pid_t child, const std::filesystem::path& out) const {
    int status = 0;
    EXPECT_EQ(::waitpid(child, &status, 0), child);
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return {code, std::filesystem::is_regular_file(out) ? testing::read_text(out) : "",
            testing::read_text(temp_.path() / "stderr")};
  }
  [[noreturn]] static void become_program(const std::vector<std::string>& arguments,
                                          const std::filesystem::path& out, const std::filesystem::path& err,
                                          rlim_t largest_file) {
    ::dup2(::open(out.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600), STDOUT_FILENO);
    ::dup2(::open(err.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600), STDERR_FILENO);
    if (largest_file > 0) {
      const rlimit limit{largest_file, largest_file};
      ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    std::vector<char*> argv = {const_cast<char*>("lineservo")};
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    ::execv(LINESERVO_TEST_PROGRAM, argv.data());
    ::_exit(127);
  }
};

}  // namespace lineservo::apps
