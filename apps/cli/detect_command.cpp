#include "apps/cli/detect_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>

#include "apps/cli/interrupt.h"
#include "apps/cli/program.h"
#include "apps/config/camera/camera_file.h"
#include "apps/config/camera/image_size.h"
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
  bool scale_camera = false;
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

/// The camera for images of each size; without a camera file one detector for all.
class SizedDetector {
 public:
  SizedDetector(const features::ImageDetectorOptions& options, OtherSize other)
      : options_(options), other_(other), detector_(options) {}

  const features::ImageDetector& for_size(const cv::Mat& image) {
    if (!options_.camera || image.size() == size_) return detector_;
    features::ImageDetectorOptions sized = options_;
    sized.camera = camera_for_size(*options_.camera, image.cols, image.rows, other_);
    detector_ = features::ImageDetector(sized);
    size_ = image.size();
    return detector_;
  }

 private:
  const features::ImageDetectorOptions options_;
  const OtherSize other_;
  features::ImageDetector detector_;
  cv::Size size_;
};

DetectionReport look_at(const std::string& file, const DetectArguments& arguments, SizedDetector& detectors) {
  DetectionReport report{.image = file, .method = arguments.method, .detection = {}, .error = {}};
  try {
    const cv::Mat image = read_image(file);
    report.width_px = image.cols;
    report.height_px = image.rows;
    const features::ImageDetector& detector = detectors.for_size(image);
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
  if (arguments.scale_camera && !arguments.camera)
    throw InputError("detect: --scale-camera needs a --camera to scale");
  SizedDetector detectors(options_of(arguments),
                          arguments.scale_camera ? OtherSize::scale : OtherSize::refuse);
  watch_for_interrupt();
  int exit_code = kDone;
  for (std::size_t done = 0; done < arguments.images.size(); ++done) {
    if (interrupted()) return broken_off(done, arguments.images.size());
    const std::string& file = arguments.images[done];
    const DetectionReport report = look_at(file, arguments, detectors);
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
  command->add_option(
      "--camera", arguments->camera,
      "camera file: ROS camera_info, OpenCV FileStorage, Kalibr camchain, ViSP XML, or YAML with "
      "width_px, height_px and focal_px; FILE#NAME takes one camera of several; without a file "
      "the picture is taken as seen straight down, without a lens");
  command->add_flag("--scale-camera", arguments->scale_camera,
                    "scale the camera to images of another size that show the same view");
  command->add_flag("--json", arguments->json, "one JSON object a line for each image");
  command->callback([arguments, &exit_code] { exit_code = detect(*arguments); });
}

}  // namespace lineservo::apps
