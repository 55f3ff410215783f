#include "apps/cli/train_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "apps/cli/interrupt.h"
#include "apps/cli/number_option.h"
#include "apps/config/input_error.h"
#include "apps/output/result_folder.h"
#include "apps/train/color_samples.h"

namespace lineservo::apps {
namespace {

struct TrainArguments {
  std::string color = "yellow", out = "yellow.yaml";
  int samples = 2000;
  std::uint64_t seed = 1;
};

void train(const TrainArguments& arguments) {
  const auto color = features::line_color(arguments.color);
  if (!color) throw InputError("train-colour: --color must be yellow, red, white or black");
  const std::filesystem::path out = arguments.out;
  end_on_interrupt("train-colour");
  ResultFolder folder(out.has_parent_path() ? out.parent_path() : ".", {out.filename().string()});
  const auto samples = color_samples(*color, arguments.samples, arguments.seed);
  const auto svm = features::ColorSvm::trained(samples);
  watch_for_interrupt();  // the file, once begun, is written whole
  folder.write(out.filename().string(), svm.to_text());
  folder.publish();
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
  add_whole_option(*command, "--samples", arguments->samples, 10, 100000, "how many colours are generated");
  add_seed_option(*command, arguments->seed, "of the generated colours");
  command->add_option("--out", arguments->out, "the file to write")->capture_default_str();
  command->callback([arguments] { train(*arguments); });
}

}  // namespace lineservo::apps
