#include "apps/cli/train_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <memory>

#include "apps/config/input_error.h"
#include "apps/train/color_samples.h"

namespace lineservo::apps {
namespace {

struct TrainArguments {
  std::string color = "yellow", out = "yellow.yaml";
  int samples = 2000;
  std::uint64_t seed = 1;
};

/// Whole or not at all.
void write_file(const std::filesystem::path& file, const std::string& text) {
  const std::filesystem::path aside = file.string() + ".part";
  std::ofstream(aside, std::ios::binary) << text;
  std::error_code error;
  if (std::filesystem::file_size(aside, error) != text.size() || error)
    throw InputError("train-colour: " + file.string() + " cannot be written");
  std::filesystem::rename(aside, file, error);
  if (error) throw InputError("train-colour: " + file.string() + ": " + error.message());
}

void train(const TrainArguments& arguments) {
  const auto color = features::line_color(arguments.color);
  if (!color) throw InputError("train-colour: --color must be yellow, red, white or black");
  const auto samples = color_samples(*color, arguments.samples, arguments.seed);
  const auto svm = features::ColorSvm::trained(samples);
  write_file(arguments.out, svm.to_text());
  const auto right =
      std::count_if(samples.begin(), samples.end(), [&svm](const features::ColorSample& sample) {
        return (svm.decision(sample.bgr) > 0.0) == sample.is_paint;
      });
  fmt::print("{}: {} of {} colours told right\n", arguments.out, right, samples.size());
}

}  // namespace

void add_train_command(CLI::App& app) {
  auto arguments = std::make_shared<TrainArguments>();
  CLI::App* command = app.add_subcommand("train-colour", "train the colour model of the svm segmenter");
  command->add_option("--color", arguments->color, "of the paint: yellow, red, white or black")
      ->capture_default_str();
  command->add_option("--samples", arguments->samples, "how many colours are generated")
      ->check(CLI::Range(10, 100000))
      ->capture_default_str();
  command->add_option("--seed", arguments->seed, "of the generated colours")->capture_default_str();
  command->add_option("--out", arguments->out, "the file to write")->capture_default_str();
  command->callback([arguments] { train(*arguments); });
}

}  // namespace lineservo::apps
