// The one part of the program that links OpenCV's image codecs: they load GDAL and much else, which takes
// longer than everything else at start. So it is a module that is loaded when the first image is read.

#include <opencv2/imgcodecs.hpp>

#include "vehicle/grabber/quiet_stderr.h"

/// False when the bytes are not an image. 8 bits, one channel or three in BGR order.
extern "C" __attribute__((visibility("default"))) bool lineservo_decode_image(const unsigned char* bytes,
                                                                              std::size_t size,
                                                                              cv::Mat* image) noexcept try {
  const lineservo::vehicle::QuietStderr quiet;
  const cv::Mat encoded(1, static_cast<int>(size), CV_8UC1, const_cast<unsigned char*>(bytes));
  *image = cv::imdecode(encoded, cv::IMREAD_ANYCOLOR);
  return !image->empty();
} catch (...) {
  return false;
}

/// The image as a file of the kind that the ending names (.png: without loss; .jpg: of that quality, 0 to
/// 100). False when it cannot be.
extern "C" __attribute__((visibility("default"))) bool lineservo_encode_image(
    const cv::Mat* image, const char* ending, int jpeg_quality, std::vector<unsigned char>* bytes) noexcept
    try {
  const lineservo::vehicle::QuietStderr quiet;
  return cv::imencode(ending, *image, *bytes, {cv::IMWRITE_JPEG_QUALITY, jpeg_quality});
} catch (...) {
  return false;
}
