#include "apps/image/image_file.h"

#include <limits>
#include <string_view>
#include <vector>

#include "apps/config/input_error.h"
#include "apps/config/text_file.h"
#include "apps/module/module_function.h"

namespace lineservo::apps {
namespace {

using Decode = bool (*)(const unsigned char* bytes, std::size_t size, cv::Mat* image);

using Encode = bool (*)(const cv::Mat* image, const char* ending, int jpeg_quality,
                        std::vector<unsigned char>* bytes);

template <typename Function>
Function codec(const char* name) {
  return module_function<Function>("liblineservo_image_codecs.so", name, "image codecs");
}

constexpr std::string_view kStart = "\xFF\xD8", kScan = "\xFF\xDA", kEnd = "\xFF\xD9";

// The first scan of a JPEG file, past the segments before it, which may hold a smaller picture with scans and
// an end of its own; npos if there is none. A segment is its marker, its length in two bytes, its content.
std::size_t first_scan(std::string_view jpeg) {
  const auto byte = [jpeg](std::size_t at) {
    return static_cast<std::size_t>(static_cast<unsigned char>(jpeg[at]));
  };
  for (std::size_t at = 2; at + 4 <= jpeg.size() && byte(at) == 0xFF;) {
    if (jpeg.substr(at, 2) == kScan) return at;
    at += byte(at + 1) == 0xFF ? 1 : 2 + 256 * byte(at + 2) + byte(at + 3);
  }
  return jpeg.npos;
}

// Decoders fill what is missing of a JPEG file with grey, where one would see floor or lines.
bool is_cut_short(std::string_view bytes) {
  if (bytes.substr(0, 2) != kStart) return false;
  const std::size_t scan = first_scan(bytes);
  return scan != bytes.npos && bytes.find(kEnd, scan) == bytes.npos;
}

std::string encoded(const cv::Mat& image, const char* ending, int jpeg_quality = 0) {
  static const Encode encode = codec<Encode>("lineservo_encode_image");
  std::vector<unsigned char> bytes;
  if (!encode(&image, ending, jpeg_quality, &bytes))
    throw std::runtime_error(std::string("an image cannot be written as ") + ending);
  return {bytes.begin(), bytes.end()};
}

}  // namespace

cv::Mat read_image(const std::filesystem::path& file) {
  static const Decode decode = codec<Decode>("lineservo_decode_image");
  const std::string bytes = read_bytes(file);
  if (bytes.empty()) throw InputError(file.string() + ": the file is empty");
  cv::Mat image;
  const bool fits = bytes.size() <= static_cast<std::size_t>(std::numeric_limits<int>::max());
  if (!fits || !decode(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(), &image))
    throw InputError(file.string() + ": not an image that can be read");
  if (is_cut_short(bytes)) throw InputError(file.string() + ": the image is cut short");
  return image;
}

std::string png_bytes(const cv::Mat& image) {
  return encoded(image, ".png");
}

std::string jpeg_bytes(const cv::Mat& image, int quality) {
  return encoded(image, ".jpg", quality);
}

}  // namespace lineservo::apps
