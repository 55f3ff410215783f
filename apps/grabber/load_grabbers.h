#pragma once

#include <memory>
#include <string>

#include "vehicle/grabber/grabbers.h"

namespace lineservo::apps {

/// vehicle::open_source(), whose libraries are loaded by the first call, not at start. Throws InputError when
/// the source cannot be opened or shows no frame. Its frames throw GrabberError, as there.
std::unique_ptr<vehicle::FrameSource> load_source(const std::string& name,
                                                  const vehicle::GrabberOptions& options);

}  // namespace lineservo::apps
