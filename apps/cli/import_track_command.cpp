#include "apps/cli/import_track_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "apps/config/input_error.h"
#include "apps/config/layout_file.h"
#include "apps/image/image_file.h"
#include "apps/output/result_folder.h"
#include "apps/track/track_import.h"
#include "features/mask/color_classes.h"

namespace lineservo::apps {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  std::string image, out;
  TrackImportOptions options;
};

void check(const Arguments& a) {
  if (!(a.options.metres_per_pixel >= 1e-4 && a.options.metres_per_pixel <= 1.0))
    throw InputError("--metres-per-pixel: must be 0.0001 to 1");
  if (fs::path(a.out).extension() != ".yaml")
    throw InputError(fmt::format("--out {}: must end in .yaml", a.out));
}

/// Whether the default segmenter takes the colour for paint.
bool is_yellow(const cv::Vec3b& bgr) {
  const features::ColorClasses classes{features::SegmenterOptions{}};
  return (classes.of(bgr[0], bgr[1], bgr[2]) & features::kPath) != 0;
}

void import_track(Arguments a) {
  check(a);
  const TrackImage image = paint_of_image(read_image(a.image), a.image);
  const fs::path out(a.out);
  a.options.name = out.stem().string();
  const std::string text = layout_of_track(image, a.options, a.image);
  const std::string file = out.filename().string();
  ResultFolder folder(out.has_parent_path() ? out.parent_path() : fs::path("."), {file});
  folder.write(file, text);
  folder.publish();
  const vehicle::Layout layout = read_layout(out);
  fmt::print("{}: {} nodes, {} lines; fly it with: lineservo fly node:NAME --layout {}{}\n", a.out,
             layout.nodes.size(), layout.edges.size(), a.out,
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
  command->callback([arguments] { import_track(*arguments); });
}

}  // namespace lineservo::apps
