#pragma once

#include <memory>
#include <string>

#include "apps/view/view_window.h"

namespace lineservo::apps {

/// ViSP's windows, whose libraries are loaded by the first call, not at start. None where there is no
/// display: `complaint` then says why.
std::unique_ptr<ViewWindow> load_window(const WindowSpec& spec, std::string& complaint);

}  // namespace lineservo::apps
