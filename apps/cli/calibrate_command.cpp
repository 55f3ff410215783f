#include "apps/cli/calibrate_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "apps/calibrate/calibration.h"
#include "apps/calibrate/camera_text.h"
#include "apps/cli/interrupt.h"
#include "apps/config/input_error.h"
#include "apps/image/image_file.h"
#include "apps/output/result_folder.h"

namespace lineservo::apps {
namespace {

namespace fs = std::filesystem;

struct CalibrateArguments {
  std::vector<std::string> images;
  std::string board;
  double square_m = 0.0;
  std::string out = "camera.yaml";
};

/// What was seen in the images, in their order.
struct Sightings {
  cv::Size image_size;
  std::vector<std::string> images;  ///< with a board, one for each of `views`
  BoardViews views;
  std::vector<std::string> without_board;
};

void take_size(const cv::Mat& image, const std::string& file, cv::Size& size) {
  if (size.empty()) size = image.size();
  if (image.size() != size)
    throw InputError(fmt::format("{}: is {}×{} px, the images before {}×{}: all must be of one size", file,
                                 image.cols, image.rows, size.width, size.height));
}

Sightings look_for_boards(const std::vector<std::string>& files, const Board& board) {
  Sightings seen;
  for (const std::string& file : files) {
    const cv::Mat image = read_image(file);
    take_size(image, file, seen.image_size);
    if (auto corners = find_board(image, board)) {
      seen.images.push_back(file);
      seen.views.push_back(std::move(*corners));
    } else {
      seen.without_board.push_back(file);
    }
  }
  return seen;
}

std::string named_list(const std::vector<std::string>& files) {
  std::string list;
  for (const std::string& file : files) list += (list.empty() ? "" : ", ") + file;
  return list;
}

/// Names the images without a board in the same line, where they are why there are too few.
void refuse_few(const Sightings& seen, const CalibrateArguments& arguments) {
  if (seen.views.size() >= kFewestViews) return;
  const std::string without = seen.without_board.empty() ? "" : "; none in " + named_list(seen.without_board);
  throw InputError(
      fmt::format("calibrate: a board of {} inner corners in {} images, at least {} are needed{}",
                  arguments.board, seen.views.size(), kFewestViews, without));
}

/// Where both files go: beside each other, both names of --out.
struct OutFiles {
  fs::path folder;
  std::string ros, visp;
};

OutFiles out_files(const fs::path& out) {
  if (out.extension() == ".xml")
    throw InputError("--out " + out.string() + ": names the YAML file; the XML file goes beside it");
  return {out.has_parent_path() ? out.parent_path() : ".", out.filename().string(),
          out.filename().replace_extension(".xml").string()};
}

void print_errors(const Sightings& seen, const Calibration& fit, const VispCalibration& visp) {
  for (std::size_t k = 0; k < seen.images.size(); ++k)
    fmt::print("{}: {:.3f} px\n", seen.images[k], fit.view_errors_px[k]);
  for (const std::string& file : seen.without_board) fmt::print("{}: no board found, left out\n", file);
  const auto& [width, height, fx, fy, cx, cy, lens] = fit.camera;
  fmt::print(
      "{} of {} images, error {:.3f} px; {}×{} px, f {:.2f}, {:.2f}, centre {:.2f}, {:.2f}, lens {:.4f} "
      "{:.4f} "
      "{:.5f} {:.5f}\n",
      seen.images.size(), seen.images.size() + seen.without_board.size(), fit.error_px, width, height, fx, fy,
      cx, cy, lens[0], lens[1], lens[2], lens[3]);
  fmt::print("ViSP's one coefficient: error {:.3f} px, kud {:.4f}, kdu {:.4f}\n", visp.error_px,
             visp.camera.distortion[0], visp.kdu);
}

void run_calibration(const CalibrateArguments& arguments) {
  const Board board = read_board(arguments.board, arguments.square_m);
  if (!(board.square_m >= 1e-4 && board.square_m <= 10.0))
    throw InputError(fmt::format("--square {}: must be from 0.0001 to 10 metres", board.square_m));
  const OutFiles files = out_files(arguments.out);
  end_on_interrupt("calibrate");
  ResultFolder folder(files.folder, {files.visp, files.ros});
  const Sightings seen = look_for_boards(arguments.images, board);
  refuse_few(seen, arguments);
  const Calibration fit = calibrate(seen.views, board, seen.image_size);
  const VispCalibration visp = calibrate_visp(seen.views, board, seen.image_size);
  watch_for_interrupt();  // the files, once begun, are written whole
  folder.write(files.visp, visp_text(visp));
  folder.write(files.ros, ros_text(fit.camera));
  folder.publish();
  print_errors(seen, fit, visp);
  fmt::print("written to {} and {}\n", (files.folder / files.ros).string(),
             (files.folder / files.visp).string());
}

}  // namespace

void add_calibrate_command(CLI::App& app) {
  const auto arguments = std::make_shared<CalibrateArguments>();
  CLI::App* command = app.add_subcommand("calibrate", "a camera file from pictures of a chessboard");
  command
      ->add_option("IMAGE", arguments->images,
                   "image files, all of one size; those without the board are left out")
      ->required();
  command->add_option("--board", arguments->board, "inner corners, columns by rows: 9x6")->required();
  command->add_option("--square", arguments->square_m, "side of a square, m")->required();
  command->add_option("--out", arguments->out, "ROS camera_info YAML; ViSP XML goes beside it, named .xml")
      ->capture_default_str();
  command->callback([arguments] { run_calibration(*arguments); });
}

}  // namespace lineservo::apps
