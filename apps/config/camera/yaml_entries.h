#pragma once

#include "apps/config/camera/camera_entries.h"
#include "apps/config/yaml_reader.h"

namespace lineservo::apps {

/// The members of a map: a scalar is one word; a list, also of lists, and the `data` of a matrix are as many.
/// Other maps are entries without words. Throws InputError when a matrix has not rows times cols numbers.
CameraEntries entries_of(const YamlReader& yaml, const YAML::Node& map);

}  // namespace lineservo::apps
