#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "features/mask/difference_segmenter.h"
#include "features/mask/line_color.h"
#include "features/mask/segmenter.h"
#include "features/mask/segmenter_options.h"

namespace lineservo::features {

/// A segmenter by its name, with what some of them need.
struct SegmenterChoice {
  std::string name = "hsv";             ///< of segmenter_names()
  LineColor color = LineColor::yellow;  ///< for hsv
  std::string svm_model = {};           ///< text of the colour model, for svm
  DifferenceOptions difference = {};    ///< for difference
};

/// hsv (topology), any-light (ours; yellow by hue and chroma), yellow-white (ours; both at once by fixed
/// bounds), difference (vtp; red), svm (grid) and auto (ours; any one colour but the start marker's red).
std::vector<std::string_view> segmenter_names();

/// Whether bounds on colours are all of it, so that PathSegmenter does it.
bool is_fast(const SegmenterChoice& choice);
/// The bounds that it takes: those given, but for any-light, which has its own. The size stays.
SegmenterOptions ranges_of(const SegmenterChoice& choice, const SegmenterOptions& given);

/// For the frames of one camera, one after the other. Throws std::invalid_argument for another name, with the
/// names that there are, for a model that is none, and for options out of bounds.
std::unique_ptr<Segmenter> make_segmenter(const SegmenterChoice& choice);

}  // namespace lineservo::features
