#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "features/mask/difference_segmenter.h"
#include "features/mask/line_color.h"
#include "features/mask/segmenter.h"

namespace lineservo::features {

struct SegmenterChoice {
  std::string name = "hsv";             ///< of segmenter_names()
  LineColor color = LineColor::yellow;  ///< for hsv
  std::string svm_model = {};           ///< text of the colour model, for svm
  DifferenceOptions difference = {};    ///< for difference
};

/// hsv (topology), difference (vtp; red), svm (grid) and auto (ours; any colour but the start marker's red).
std::vector<std::string_view> segmenter_names();

/// For the frames of one camera, one after the other. Throws std::invalid_argument for another name, with the
/// names that there are, for a model that is none, and for options out of bounds.
std::unique_ptr<Segmenter> make_segmenter(const SegmenterChoice& choice);

}  // namespace lineservo::features
