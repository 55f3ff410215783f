#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "apps/compare/comparison.h"

namespace lineservo::apps {

/// The flights of a paper's experiments, made ready for `compare --preset`.
struct Preset {
  std::string_view name, summary;
  std::vector<Block> blocks;
  std::string_view conditions = "paper";  ///< unless others are asked for
  bool histogram = false;                 ///< the table shows how the errors are distributed
};

const std::vector<Preset>& presets();

/// Throws InputError, with the names that there are, for an unknown one.
const Preset& find_preset(const std::string& name);

}  // namespace lineservo::apps
