#include "apps/evaluate/line_evaluation.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <memory>
#include <stdexcept>

#include "features/line/line_methods.h"
#include "features/mask/path_segmenter.h"

namespace lineservo::apps {
namespace {

const cv::Size kSizes[] = {{1920, 1080}, {640, 480}};

// Yellow as topology has it in saturation, in any light and without the blues and greens that its hue admits.
features::SegmenterOptions yellow(cv::Size mask) {
  features::SegmenterOptions options;
  options.width_px = mask.width;
  options.height_px = mask.height;
  options.path = {.h_min = 15, .h_max = 45, .s_min = 84, .s_max = 255, .v_min = 50, .v_max = 255};
  return options;
}

double milliseconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

struct Mask {
  const features::PackedMask* mask = nullptr;
  double time_ms = 0.0;
};

// One segmenter for each size of mask that a method asks for, each run once a frame.
class Masks {
 public:
  void forget() { done_.clear(); }
  Mask of(const cv::Mat& bgr, cv::Size size) {
    const auto key = std::pair(size.width, size.height);
    if (const auto done = done_.find(key); done != done_.end()) return done->second;
    auto& segmenter = segmenters_[key];
    if (!segmenter) segmenter = std::make_unique<features::PathSegmenter>(yellow(size));
    const auto start = std::chrono::steady_clock::now();
    const features::PackedMask* mask = &segmenter->segment(bgr).path;
    return done_[key] = {mask, milliseconds_since(start)};
  }

 private:
  std::map<std::pair<int, int>, std::unique_ptr<features::PathSegmenter>> segmenters_;
  std::map<std::pair<int, int>, Mask> done_;
};

struct Contestant {
  LineEvaluationRow row;
  std::unique_ptr<features::LineDetector> detector;
};

std::vector<Contestant> contestants(const LineEvaluationOptions& options, FrameLevel level, cv::Size size) {
  std::vector<Contestant> all;
  for (const features::LineMethod& method : features::line_methods()) {
    const std::string name(method.name);
    if (!options.methods.empty() && std::ranges::find(options.methods, name) == options.methods.end())
      continue;
    const LineEvaluationRow row{.method = name, .level = level, .size = size, .score = {}};
    all.push_back({row, method.make()});
    if (!method.uses_camera) continue;
    all.push_back({row, method.make()});
    all.back().row.told_tilt = true;
  }
  return all;
}

void run(Contestant& contestant, const LineFrame& frame, Masks& masks) {
  LineScore& score = contestant.row.score;
  const Mask mask = masks.of(frame.bgr, contestant.detector->mask_size(frame.bgr.size()));
  const features::LineScene scene{
      .image = frame.bgr, .mask = *mask.mask, .camera = contestant.row.told_tilt ? &frame.camera : nullptr};
  const auto start = std::chrono::steady_clock::now();
  const std::vector<features::DetectedLine> lines = contestant.detector->detect(scene);
  score.time_ms += milliseconds_since(start);
  score.mask_ms += mask.time_ms;
  score.add(frame.truth, lines.empty() ? std::nullopt : std::optional(lines.front().image));
}

void check(const LineEvaluationOptions& options) {
  if (options.frames < 1 || options.frames > 100000)
    throw std::invalid_argument("evaluate lines: frames must be 1 to 100000");
  if (!(options.empty_share >= 0.0 && options.empty_share <= 1.0))
    throw std::invalid_argument("evaluate lines: the share of frames without a line must be 0 to 1");
  for (const std::string& method : options.methods) features::find_line_method(method);
}

std::vector<FrameLevel> levels_of(const LineEvaluationOptions& options) {
  if (options.levels.empty()) return {std::begin(kFrameLevels), std::end(kFrameLevels)};
  std::vector<FrameLevel> levels;
  for (const std::string& name : options.levels) {
    const auto level = std::ranges::find(kFrameLevels, name, name_of);
    if (level == std::end(kFrameLevels))
      throw std::invalid_argument("evaluate lines: level '" + name +
                                  "' is not one of clean, real-like, harsh");
    levels.push_back(*level);
  }
  return levels;
}

}  // namespace

std::vector<LineEvaluationRow> evaluate_lines(const LineEvaluationOptions& options,
                                              const std::function<bool(double)>& progress) {
  check(options);
  const std::vector<FrameLevel> levels = levels_of(options);
  const double total = 1.0 * options.frames * static_cast<double>(std::size(kSizes) * levels.size());
  std::vector<LineEvaluationRow> rows;
  Masks masks;
  int done = 0;
  bool go_on = true;
  for (const cv::Size size : kSizes) {
    for (const FrameLevel level : levels) {
      std::vector<Contestant> runners = contestants(options, level, size);
      for (int index = 0; index < options.frames && go_on; ++index) {
        const LineFrame frame = make_line_frame(size, level, options.seed, index, options.empty_share);
        masks.forget();
        for (Contestant& runner : runners) run(runner, frame, masks);
        go_on = progress(++done / total);
      }
      for (Contestant& runner : runners)
        if (runner.row.score.frames() > 0) rows.push_back(std::move(runner.row));
    }
  }
  return rows;
}

}  // namespace lineservo::apps
