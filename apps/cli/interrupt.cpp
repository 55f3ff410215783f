#include "apps/cli/interrupt.h"

#include <csignal>

namespace lineservo::apps {
namespace {

volatile std::sig_atomic_t pressed = 0;

}  // namespace

void watch_for_interrupt() {
  std::signal(SIGINT, [](int) { pressed = 1; });
}

bool interrupted() {
  return pressed != 0;
}

}  // namespace lineservo::apps
