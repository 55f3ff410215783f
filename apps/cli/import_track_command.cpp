#include "apps/cli/import_track_command.h"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <memory>

#include "apps/config/input_error.h"
#include "apps/config/layout_bitmap.h"
#include "apps/config/layout_file.h"
#include "apps/config/program_name.h"
#include "apps/config/text_file.h"
#include "apps/image/image_file.h"
#include "apps/output/result_folder.h"
#include "apps/output/shell_word.h"
#include "apps/track/track_import.h"
#include "features/mask/color_classes.h"

namespace lineservo::apps {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  std::string image, out;
  bool as_floor = false;
  TrackImportOptions options;
};

void check(const Arguments& a) {
  if (!(a.options.metres_per_pixel >= 1e-4 && a.options.metres_per_pixel <= 1.0))
    throw InputError("--metres-per-pixel: must be 0.0001 to 1");
  if (fs::path(a.out).extension() != ".yaml")
    throw InputError(fmt::format("--out {}: must end in .yaml", a.out));
  if (!(a.options.start_disc_m >= 0.0 && a.options.start_disc_m <= 2.0))
    throw InputError("--start-disc: must be 0 (none) to 2");
  const std::string name = fs::path(a.image).filename();
  if (a.as_floor && !is_bitmap_name(name))
    throw InputError(fmt::format("--bitmap: {}: must end in {}", a.image, kBitmapEndings));
  if (a.as_floor && name.find_first_of("\"\\") != name.npos)
    throw InputError(fmt::format("--bitmap: {}: a name with quotes or backslashes is no layout's", a.image));
}

/// Whether the default segmenter takes the colour for paint.
bool is_yellow(const cv::Vec3b& bgr) {
  const features::ColorClasses classes{features::SegmenterOptions{}};
  return (classes.of(bgr[0], bgr[1], bgr[2]) & features::kPath) != 0;
}

fs::path folder_of(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

/// A folder of its own, with the layout and its bitmap as they are to be; gone with the object.
class Rehearsal {
 public:
  Rehearsal(const Arguments& a, const std::string& layout)
      : folder_(fs::temp_directory_path() / fmt::format("lineservo-import-{}", ::getpid())),
        file_(folder_ / fs::path(a.out).filename()) {
    fs::create_directories(folder_);
    std::ofstream(file_, std::ios::binary) << layout;
    if (a.as_floor) fs::create_symlink(fs::absolute(a.image), folder_ / a.options.bitmap);
  }
  ~Rehearsal() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  Rehearsal(const Rehearsal&) = delete;
  Rehearsal& operator=(const Rehearsal&) = delete;

  const fs::path& file() const { return file_; }

 private:
  fs::path folder_, file_;
};

/// The layout as it will be read; throws InputError when it would be refused, before anything is written.
vehicle::Layout rehearsed(const Arguments& a, const std::string& text) {
  const Rehearsal rehearsal(a, text);
  try {
    return read_layout(rehearsal.file());
  } catch (const InputError& refusal) {
    std::string why = refusal.what();
    const std::string rehearsed_file = rehearsal.file().string();
    if (why.starts_with(rehearsed_file)) why.replace(0, rehearsed_file.size(), a.out);
    throw InputError(fmt::format("{}: gives no layout that can be flown: {}", a.image, why));
  }
}

void keep_other_image(const Arguments& a, const fs::path& there) {
  std::error_code error;
  if (fs::exists(there, error) && read_bytes(there) != read_bytes(a.image))
    throw InputError(fmt::format("--bitmap: {}: another image of this name is there", there.string()));
}

/// The layout, and beside it the image where it is the floor and not there already.
void write(const Arguments& a, const fs::path& where, const std::string& layout) {
  const std::string file = fs::path(a.out).filename();
  std::error_code not_there;
  const bool copies = a.as_floor && !fs::equivalent(a.image, where / a.options.bitmap, not_there);
  if (copies) keep_other_image(a, where / a.options.bitmap);
  ResultFolder folder(where, copies ? std::vector{a.options.bitmap, file} : std::vector{file});
  if (copies) folder.write(a.options.bitmap, read_bytes(a.image));
  folder.write(file, layout);
  folder.publish();
}

void import_track(Arguments a) {
  check(a);
  const TrackImage image = paint_of_image(read_image(a.image), a.image);
  const fs::path out(a.out);
  a.options.name = out.stem().string();
  if (a.as_floor) a.options.bitmap = fs::path(a.image).filename();
  const std::string text = layout_of_track(image, a.options, a.image);
  const vehicle::Layout layout = rehearsed(a, text);
  write(a, folder_of(out), text);
  fmt::print("{}: {} nodes, {} lines; fly it with: {} fly node:NAME --layout {}{}\n", a.out,
             layout.nodes.size(), layout.edges.size(), for_shell(program_name()), for_shell(a.out),
             is_yellow(image.line_bgr) ? "" : " --set features.segmenter=auto");
}

}  // namespace

void add_import_track_command(CLI::App& app) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("import-track", "trace a bitmap of lines into a layout to fly on");
  command->add_option("IMAGE", arguments->image, "an image of lines on a plain floor, seen from above")
      ->required();
  command->add_option("--metres-per-pixel", arguments->options.metres_per_pixel, "how much floor a pixel is")
      ->required();
  command->add_option("--out", arguments->out, "the layout file (*.yaml)")->required();
  command->add_option("--start", arguments->options.start,
                      "the node of take-off (default: the dead end that is furthest to the left)");
  command->add_flag(
      "--bitmap", arguments->as_floor,
      "fly on the image itself, which is copied beside the layout (default: on the traced lines)");
  command->add_option("--start-disc", arguments->options.start_disc_m,
                      "the radius of a red disc on the node of take-off, in metres (default: none)");
  command->callback([arguments] { import_track(*arguments); });
}

}  // namespace lineservo::apps
