// The one part of the program that links OpenCV's image codecs: they load GDAL and much else, which takes
// longer than everything else at start. So it is a module that is loaded when the first image is read.

#include <fcntl.h>
#include <unistd.h>

#include <opencv2/imgcodecs.hpp>

namespace {

/// Nothing reaches stderr as long as it lives: libpng and others write there of themselves what the caller
/// says in one line. Nobody else may write there meanwhile.
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

}  // namespace

/// False when the bytes are not an image. 8 bits, one channel or three in BGR order.
extern "C" __attribute__((visibility("default"))) bool lineservo_decode_image(const unsigned char* bytes,
                                                                              std::size_t size,
                                                                              cv::Mat* image) noexcept try {
  const QuietStderr quiet;
  const cv::Mat encoded(1, static_cast<int>(size), CV_8UC1, const_cast<unsigned char*>(bytes));
  *image = cv::imdecode(encoded, cv::IMREAD_ANYCOLOR);
  return !image->empty();
} catch (...) {
  return false;
}
