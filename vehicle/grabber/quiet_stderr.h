#pragma once

#include <fcntl.h>
#include <unistd.h>

namespace lineservo::vehicle {

/// Nothing reaches stderr as long as it lives: libpng, FFmpeg and others write there of themselves what the
/// caller says in one line. Nobody else may write there meanwhile.
class QuietStderr {
 public:
  QuietStderr()
      : stderr_(::fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 0)),
        null_(::open("/dev/null", O_WRONLY | O_CLOEXEC)) {
    if (stderr_ >= 0 && null_ >= 0) ::dup2(null_, STDERR_FILENO);
  }
  ~QuietStderr() {
    if (stderr_ >= 0) {
      ::dup2(stderr_, STDERR_FILENO);
      ::close(stderr_);
    }
    if (null_ >= 0) ::close(null_);
  }
  QuietStderr(const QuietStderr&) = delete;
  QuietStderr& operator=(const QuietStderr&) = delete;

 private:
  int stderr_, null_;
};

}  // namespace lineservo::vehicle
