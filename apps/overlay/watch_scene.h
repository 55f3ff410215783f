#pragma once

#include "apps/overlay/overlay.h"
#include "apps/watch/open_watch.h"
#include "apps/watch/watch.h"

namespace lineservo::apps {

/// The overlay of what is watched: as the first controller sees it, and its command.
Overlay watch_overlay(const OpenWatch& opened, const std::string& source,
                      std::vector<std::string> notes = {});

/// What it shows of a tick.
OverlayScene scene_of(const Watched& watched);

}  // namespace lineservo::apps
