#pragma once

#include <array>
#include <string>

namespace lineservo::support {

/// ViSP's own camera, behind a header that shows nothing of ViSP (its headers are C++17).
struct VispCamera {
  double px = 0.0, py = 0.0, u0 = 0.0, v0 = 0.0, kud = 0.0, kdu = 0.0;

  /// Where ViSP puts a point of the normalised plane, px.
  std::array<double, 2> pixel(double x, double y) const;
  /// The way back, with kdu.
  std::array<double, 2> point(double u, double v) const;
};

/// By vpXmlParserCamera; false when it fails.
bool save_visp_camera(const VispCamera& camera, const std::string& file, const std::string& name,
                      int width_px, int height_px);
/// The model with distortion; false when vpXmlParserCamera does not find it.
bool load_visp_camera(VispCamera& camera, const std::string& file, const std::string& name, int width_px,
                      int height_px);

}  // namespace lineservo::support
