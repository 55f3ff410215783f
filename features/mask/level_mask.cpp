#include "features/mask/level_mask.h"

namespace lineservo::features {

LevelMask::LevelMask(const MaskView& mask, const MaskGeometry& geometry, const LevelView& view)
    : mask_(mask),
      geometry_(geometry),
      view_(view),
      mask_H_L_(geometry.pinhole() * view.R_LC().transpose()) {}

}  // namespace lineservo::features
