#include "features/detect/segmenters.h"

#include <stdexcept>
#include <string>

#include "features/detect/steady_segmenter.h"
#include "features/mask/hsv_segmenter.h"
#include "features/mask/svm_segmenter.h"

namespace lineservo::features {

namespace {

// Red is the colour of the start marker, which is in view before any line is.
SteadyOptions beside_red_markers() {
  SteadyOptions options;
  std::erase(options.search.colors, LineColor::red);
  return options;
}

}  // namespace

std::vector<std::string_view> segmenter_names() {
  return {"hsv", "any-light", "yellow-white", "difference", "svm", "auto"};
}

bool is_fast(const SegmenterChoice& choice) {
  return choice.name == "hsv" || choice.name == "any-light";
}

SegmenterOptions ranges_of(const SegmenterChoice& choice, const SegmenterOptions& given) {
  if (choice.name != "any-light") return given;
  SegmenterOptions ranges = any_light_ranges();
  ranges.width_px = given.width_px;
  ranges.height_px = given.height_px;
  return ranges;
}

std::unique_ptr<Segmenter> make_segmenter(const SegmenterChoice& choice) {
  if (choice.name == "hsv") return std::make_unique<HsvSegmenter>(choice.color);
  if (choice.name == "any-light") return std::make_unique<HsvSegmenter>(any_light_ranges());
  if (choice.name == "yellow-white")
    return std::make_unique<PaintsSegmenter>(std::vector{LineColor::yellow, LineColor::white});
  if (choice.name == "difference") return std::make_unique<DifferenceSegmenter>(choice.difference);
  if (choice.name == "svm")
    return std::make_unique<SvmSegmenter>(ColorSvm::from_text(std::string(choice.svm_model)));
  if (choice.name == "auto") return std::make_unique<SteadySegmenter>(beside_red_markers());
  throw std::invalid_argument("no segmenter '" + std::string(choice.name) +
                              "'; there are: hsv, any-light, yellow-white, difference, svm, auto");
}

}  // namespace lineservo::features
