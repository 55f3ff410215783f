#include "apps/image/image_file.h"

#include <dlfcn.h>

#include <fstream>
#include <iterator>
#include <limits>
#include <vector>

#include "apps/config/input_error.h"

namespace lineservo::apps {
namespace {

using Decode = bool (*)(const unsigned char* bytes, std::size_t size, cv::Mat* image);

Decode load_decoder() {
  void* module = ::dlopen("liblineservo_image_codecs.so", RTLD_NOW | RTLD_LOCAL);
  void* symbol = module == nullptr ? nullptr : ::dlsym(module, "lineservo_decode_image");
  if (symbol == nullptr)
    throw std::runtime_error(std::string("the image codecs do not load: ") + ::dlerror());
  return reinterpret_cast<Decode>(symbol);
}

std::vector<char> bytes_of(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) throw InputError(file.string() + ": not a file");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw InputError(file.string() + ": cannot be read");
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

cv::Mat read_image(const std::filesystem::path& file) {
  static const Decode decode = load_decoder();
  const std::vector<char> bytes = bytes_of(file);
  if (bytes.empty()) throw InputError(file.string() + ": the file is empty");
  cv::Mat image;
  const bool fits = bytes.size() <= static_cast<std::size_t>(std::numeric_limits<int>::max());
  if (!fits || !decode(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(), &image))
    throw InputError(file.string() + ": not an image that can be read");
  return image;
}

}  // namespace lineservo::apps
