#pragma once

#include <array>

namespace lineservo::features {

/// Inclusive bounds on 8-bit HSV as OpenCV stores it: H 0…180 half degrees, S and V 0…255; and on the chroma,
/// max(B, G, R) − min(B, G, R), which white light that is added (a reflection) leaves alone.
struct HsvBounds {
  int h_min = 0, h_max = 180;
  int s_min = 0, s_max = 255;
  int v_min = 0, v_max = 255;
  int c_min = 0;  ///< 0…255
};

/// What the segmentation looks for; the defaults are those of topology §2.5.
struct SegmenterOptions {
  int width_px = 400;   ///< of the resized frame
  int height_px = 400;  ///< of the resized frame
  /// Yellow. The upper hue is as printed and also admits the reds of hue 170 to 175.
  HsvBounds path{18, 175, 84, 255, 140, 255};
  /// Red wraps around hue 0: a pixel in either range counts.
  std::array<HsvBounds, 2> marker{HsvBounds{0, 10, 100, 255, 100, 255},
                                  HsvBounds{170, 180, 100, 255, 100, 255}};
};

/// Yellow and red paint under light that no bound on V or S fits: hue and chroma alone. Light c → a·c + b
/// (shade, reflections) leaves the hue; the chroma of paint falls with the light, that of grey floor is its
/// noise.
SegmenterOptions any_light_ranges();

/// Throws std::invalid_argument that lists every fault: sides of 16 to 4096 px, 0 ≤ min ≤ max within each
/// channel's range.
void validate(const SegmenterOptions& options);

}  // namespace lineservo::features
