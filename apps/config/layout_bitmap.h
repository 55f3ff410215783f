#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "apps/config/yaml_reader.h"
#include "vehicle/floor/floor_bitmap.h"

namespace lineservo::apps {

/// What the name of a bitmap may end in.
inline constexpr const char* kBitmapEndings = ".png, .jpg, .jpeg, .bmp, .tif, .tiff, .ppm or .pgm";

/// Whether a file of this name can be a layout's bitmap: an image's, without a folder, so that it lies beside
/// the layout and is copied with it.
bool is_bitmap_name(const std::string& name);

/// The bitmap that a layout shows, or none: bitmap {file, metres_per_pixel, x_m, y_m}, the last two of the
/// middle of its lower left pixel. Layouts with the same bitmap share it. Throws InputError naming file, line
/// and key. Not for several threads at once, as read_image().
std::shared_ptr<const vehicle::FloorBitmap> read_bitmap(const YamlReader& layout);

/// The file of a layout's bitmap, or none. Throws InputError when the layout cannot be read.
std::optional<std::filesystem::path> bitmap_file(const std::filesystem::path& layout);

}  // namespace lineservo::apps
