#include "apps/config/camera/image_size.h"

#include <fmt/format.h>

#include <cmath>

#include "apps/config/input_error.h"

namespace lineservo::apps {
namespace {

/// w'/w = h'/h within a pixel of either new side.
bool same_view(const features::CameraParameters& camera, int width_px, int height_px) {
  const double w = camera.width_px, h = camera.height_px;
  return std::abs(width_px * h - height_px * w) <= std::max(w, h);
}

}  // namespace

features::CameraParameters camera_for_size(const features::CameraParameters& camera, int width_px,
                                           int height_px, OtherSize other) {
  if (camera.width_px == width_px && camera.height_px == height_px) return camera;
  const std::string sizes = fmt::format("the image is {}×{} px, the camera {}×{}", width_px, height_px,
                                        camera.width_px, camera.height_px);
  if (other == OtherSize::refuse)
    throw InputError(sizes + " (--scale-camera scales it, if both show the same view)");
  if (!same_view(camera, width_px, height_px))
    throw InputError(sizes + ": sides of another ratio, which no scale makes equal");
  const double sx = static_cast<double>(width_px) / camera.width_px;
  const double sy = static_cast<double>(height_px) / camera.height_px;
  features::CameraParameters scaled = camera;
  scaled.width_px = width_px;
  scaled.height_px = height_px;
  scaled.fx_px *= sx;
  scaled.fy_px *= sy;
  scaled.cx_px = sx * (camera.cx_px + 0.5) - 0.5;
  scaled.cy_px = sy * (camera.cy_px + 0.5) - 0.5;
  return scaled;
}

}  // namespace lineservo::apps
