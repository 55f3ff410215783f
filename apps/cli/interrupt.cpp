#include "apps/cli/interrupt.h"

#include <fmt/format.h>
#include <unistd.h>

#include <csignal>

#include "apps/cli/program.h"

namespace lineservo::apps {
namespace {

volatile std::sig_atomic_t pressed = 0;
std::string last_words;  // made before the signal may come: a handler must not allocate

void write_last_words() {
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, last_words.data(), last_words.size());
}

/// Ctrl-C, what ends programs, and a terminal that was closed: but for the last where nohup has it ignored.
void on_interrupt(void (*handler)(int)) {
  std::signal(SIGINT, handler);
  std::signal(SIGTERM, handler);
  if (std::signal(SIGHUP, handler) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
}

void set_last_words(const std::string& command) {
  const char* const wipe = ::isatty(STDERR_FILENO) == 1 ? "\r\033[K" : "";
  last_words = fmt::format("{}lineservo: {}: interrupted; nothing is written\n", wipe, command);
}

}  // namespace

void watch_for_interrupt() {
  on_interrupt([](int) { pressed = 1; });
}

bool interrupted() {
  return pressed != 0;
}

void end_on_interrupt(const std::string& command) {
  set_last_words(command);
  on_interrupt([](int) {
    write_last_words();
    ::_exit(kFailed);
  });
}

void say_nothing_is_written(const std::string& command) {
  set_last_words(command);
  write_last_words();
}

}  // namespace lineservo::apps
