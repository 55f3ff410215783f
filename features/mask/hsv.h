#pragma once

#include <cstdint>

namespace lineservo::features {

/// A colour as 8-bit OpenCV writes it: hue in half degrees 0…179, saturation and value 0…255.
struct Hsv {
  int h = 0;
  int s = 0;
  int v = 0;
};

/// The rounded fixed-point arithmetic of cv::cvtColor(COLOR_BGR2HSV) on 8-bit images, bit for bit.
/// With v = max(b, g, r) and chroma c = v − min(b, g, r):
///   s = 255 c / v,   h = 30 n / c (half degrees), where the numerator n is
///   g − b when red is the largest, else b − r + 2c when green is, else r − g + 4c.
Hsv hsv_of(int b, int g, int r);

/// Hue before wrapping, −30…150, of numerator n ∈ [−c, 5c] and chroma c ∈ [0, 255].
int raw_hue(int numerator, int chroma);
/// Hue as stored: 180 added to the negative ones.
int hue(int numerator, int chroma);
/// Saturation of chroma c ≤ v.
int saturation(int chroma, int value);

}  // namespace lineservo::features
