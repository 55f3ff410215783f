#pragma once

#include <string>
#include <vector>

#include "apps/watch/watch.h"

namespace lineservo::apps {

/// The CSV that watch prints: what the first controller sees, then what each would command. Columns that
/// flight.csv has too are written as there; what is absent is nan.
std::string watch_header(const std::vector<std::string>& controllers);
std::string watch_row(const Watched& watched);

}  // namespace lineservo::apps
