#pragma once

#include "features/geometry/camera_model.h"

namespace lineservo::apps {

/// What to do when images are not of the camera file's size.
enum class OtherSize {
  refuse,
  scale,  ///< the images show the same view with more or fewer pixels
};

/// The camera for images of this size. Scaled: with s the ratio of widths, fx' = s fx and, as pixel centres
/// have whole coordinates, cx' = s (cx + ½) − ½; likewise fy and cy with the ratio of heights; the lens
/// stays. Throws InputError when the sizes differ and are to be refused, or when their aspects differ by more
/// than the rounding of a side to whole pixels: such images are cut, not scaled.
features::CameraParameters camera_for_size(const features::CameraParameters& camera, int width_px,
                                           int height_px, OtherSize other = OtherSize::refuse);

}  // namespace lineservo::apps
