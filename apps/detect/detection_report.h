#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "features/detect/image_detector.h"

namespace lineservo::apps {

/// What `detect` says of one image: a detection, or what was wrong with the image.
struct DetectionReport {
  std::string image;  ///< as typed
  std::string method;
  int width_px = 0, height_px = 0;
  features::ImageDetection detection;
  double perception_ms = 0.0;
  std::optional<std::string> error;
};

/// One object with the fields of the command line's contract, in their order; what was not seen is null.
nlohmann::ordered_json to_json(const DetectionReport& report);

/// The same for people: a line for the image and one for each line in view.
std::string to_text(const DetectionReport& report);

}  // namespace lineservo::apps
