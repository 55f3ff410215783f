#include "apps/cli/detect_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>

#include "apps/cli/interrupt.h"
#include "apps/cli/program.h"
#include "apps/config/camera_file.h"
#include "apps/config/input_error.h"
#include "apps/detect/detection_report.h"
#include "apps/image/image_file.h"
#include "apps/output/json_text.h"

namespace lineservo::apps {
namespace {

struct DetectArguments {
  std::vector<std::string> images;
  std::string method = "stripe";
  std::string color = "auto";
  std::optional<std::string> camera;
  bool json = false;
};

std::vector<features::LineColor> colors_of(const std::string& word) {
  if (word == "auto") return {features::kLineColors.begin(), features::kLineColors.end()};
  if (const auto color = features::line_color(word)) return {*color};
  throw InputError("detect: --color '" + word + "' must be yellow, red, white, black or auto");
}

features::ImageDetectorOptions options_of(const DetectArguments& arguments) {
  features::ImageDetectorOptions options;
  options.method = arguments.method;
  options.segmenter.colors = colors_of(arguments.color);
  if (arguments.camera) options.camera = read_camera(*arguments.camera);
  return options;
}

DetectionReport look_at(const std::string& file, const DetectArguments& arguments,
                        const features::ImageDetector& detector) {
  DetectionReport report{.image = file, .method = arguments.method, .detection = {}, .error = {}};
  try {
    const cv::Mat image = read_image(file);
    report.width_px = image.cols;
    report.height_px = image.rows;
    const auto start = std::chrono::steady_clock::now();
    report.detection = detector.detect(image);
    report.perception_ms =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  } catch (const InputError& fault) {
    report.error = fault.what();
  } catch (const std::invalid_argument& fault) {
    report.error = fault.what();
  }
  return report;
}

int broken_off(std::size_t done, std::size_t images) {
  fmt::print(stderr, "lineservo: detect: interrupted; after {} of {} images\n", done, images);
  return kFailed;
}

/// An image that cannot be read does not stop the others.
int detect(const DetectArguments& arguments) {
  const features::ImageDetector detector(options_of(arguments));
  watch_for_interrupt();
  int exit_code = kDone;
  for (std::size_t done = 0; done < arguments.images.size(); ++done) {
    if (interrupted()) return broken_off(done, arguments.images.size());
    const std::string& file = arguments.images[done];
    const DetectionReport report = look_at(file, arguments, detector);
    if (report.error) exit_code = kFailed;
    fmt::print("{}", arguments.json ? json_text(to_json(report)) : to_text(report));
  }
  return exit_code;
}

}  // namespace

void add_detect_command(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<DetectArguments>();
  CLI::App* command = app.add_subcommand("detect", "find the lines and the junction in image files");
  command->add_option("IMAGE", arguments->images, "image files, grey or colour, of any size")->required();
  command
      ->add_option(
          "--method", arguments->method,
          "how lines are found: stripe, subpixel, centroid, slices, fitline, skeleton, combined or naive")
      ->capture_default_str();
  command->add_option("--color", arguments->color, "of the line: yellow, red, white, black or auto")
      ->capture_default_str();
  command->add_option("--camera", arguments->camera,
                      "YAML file of the camera; without one the picture is taken "
                      "as seen straight down, without a lens");
  command->add_flag("--json", arguments->json, "one JSON object a line for each image");
  command->callback([arguments, &exit_code] { exit_code = detect(*arguments); });
}

}  // namespace lineservo::apps
