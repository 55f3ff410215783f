#include "apps/config/layout_bitmap.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <tuple>

#include "apps/config/input_error.h"
#include "apps/image/image_file.h"
#include "vehicle/floor/layout.h"

namespace lineservo::apps {
namespace {

namespace fs = std::filesystem;
using vehicle::FloorBitmap;

struct Entry {
  fs::path file;
  double metres_per_pixel = 0.0, x_m = 0.0, y_m = 0.0;
};

fs::path beside(const YamlReader& layout, const YAML::Node& map) {
  const std::string name = layout.text(map, "file");
  if (!is_bitmap_name(name))
    layout.fail(
        map["file"],
        fmt::format("'file' of bitmap must name an image ({}) beside the layout, without a folder: '{}'",
                    kBitmapEndings, name));
  return layout.file().parent_path() / name;
}

Entry entry_of(const YamlReader& layout, const YAML::Node& map) {
  layout.allow(map, {"file", "metres_per_pixel", "x_m", "y_m"}, "bitmap");
  const Entry entry{beside(layout, map), layout.number(map, "metres_per_pixel"),
                    layout.number(map, "x_m", 0.0), layout.number(map, "y_m", 0.0)};
  if (!(entry.metres_per_pixel >= FloorBitmap::kFinest_m &&
        entry.metres_per_pixel <= FloorBitmap::kCoarsest_m))
    layout.fail(map["metres_per_pixel"], "'metres_per_pixel' of bitmap must be 0.0001 to 1");
  if (std::max(std::abs(entry.x_m), std::abs(entry.y_m)) > vehicle::kFarthest_m)
    layout.fail(map, "x and y must be -10000 to 10000 m");
  return entry;
}

cv::Mat in_colour(cv::Mat image) {
  if (image.channels() == 1) cv::cvtColor(image, image, cv::COLOR_GRAY2BGR);
  return image;
}

std::shared_ptr<const FloorBitmap> load(const Entry& entry) try {
  return std::make_shared<const FloorBitmap>(in_colour(read_image(entry.file)), entry.metres_per_pixel,
                                             Eigen::Vector2d(entry.x_m, entry.y_m));
} catch (const std::invalid_argument& fault) {
  throw InputError(entry.file.string() + ": " + fault.what());
}

/// A comparison reads one layout for each of its flights, and large pictures once.
std::shared_ptr<const FloorBitmap> shared(const Entry& entry) {
  using Key = std::tuple<fs::path, fs::file_time_type, double, double, double>;
  static std::map<Key, std::weak_ptr<const FloorBitmap>> in_use;
  std::error_code error;  // a file that is not there says so when it is read
  const Key key{fs::weakly_canonical(entry.file, error), fs::last_write_time(entry.file, error),
                entry.metres_per_pixel, entry.x_m, entry.y_m};
  std::erase_if(in_use, [](const auto& item) { return item.second.expired(); });
  if (const auto known = in_use.find(key); known != in_use.end()) return known->second.lock();
  auto bitmap = load(entry);
  in_use.emplace(key, bitmap);
  return bitmap;
}

}  // namespace

bool is_bitmap_name(const std::string& name) {
  static constexpr std::array kImages = {".png", ".jpg", ".jpeg", ".bmp", ".tif", ".tiff", ".ppm", ".pgm"};
  const fs::path path(name);
  std::string extension = path.extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
  return path.filename() == path && std::ranges::find(kImages, extension) != kImages.end();
}

std::shared_ptr<const FloorBitmap> read_bitmap(const YamlReader& layout) {
  const YAML::Node map = layout.root()["bitmap"];
  if (!map) return nullptr;
  return shared(entry_of(layout, map));
}

std::optional<fs::path> bitmap_file(const fs::path& layout) {
  const YamlReader yaml(layout);
  const YAML::Node map = yaml.root()["bitmap"];
  if (!map) return std::nullopt;
  return beside(yaml, map);
}

}  // namespace lineservo::apps
