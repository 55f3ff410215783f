#pragma once

#include "apps/overlay/canvas.h"
#include "apps/overlay/overlay_scene.h"
#include "features/geometry/camera_model.h"

namespace lineservo::apps {

/// Draws what perception saw onto a picture of the frame that is `zoom` times as large: the outline of the
/// path mask (sky blue), every line from its begin (ring) to its end (disc) with the one to follow in blue,
/// the law's own line (orange), the junction's centre with its arms (vermilion) and code, the law's target
/// point (purple diamond) and centroid (green cross).
void draw_features(Canvas& canvas, const features::CameraModel& camera, const OverlayScene& scene, int zoom);

}  // namespace lineservo::apps
