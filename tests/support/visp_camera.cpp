#include "tests/support/visp_camera.h"

#include <visp3/core/vpMeterPixelConversion.h>
#include <visp3/core/vpPixelMeterConversion.h>
#include <visp3/core/vpXmlParserCamera.h>

namespace lineservo::support {
namespace {

vpCameraParameters parameters(const VispCamera& c) {
  vpCameraParameters visp;
  visp.initPersProjWithDistortion(c.px, c.py, c.u0, c.v0, c.kud, c.kdu);
  return visp;
}

}  // namespace

std::array<double, 2> VispCamera::pixel(double x, double y) const {
  std::array<double, 2> pixel{};
  vpMeterPixelConversion::convertPoint(parameters(*this), x, y, pixel[0], pixel[1]);
  return pixel;
}

std::array<double, 2> VispCamera::point(double u, double v) const {
  std::array<double, 2> point{};
  vpPixelMeterConversion::convertPoint(parameters(*this), u, v, point[0], point[1]);
  return point;
}

bool save_visp_camera(const VispCamera& camera, const std::string& file, const std::string& name,
                      int width_px, int height_px) {
  vpXmlParserCamera parser;
  return parser.save(parameters(camera), file, name, static_cast<unsigned>(width_px),
                     static_cast<unsigned>(height_px)) == vpXmlParserCamera::SEQUENCE_OK;
}

bool load_visp_camera(VispCamera& camera, const std::string& file, const std::string& name, int width_px,
                      int height_px) {
  vpXmlParserCamera parser;
  vpCameraParameters c;
  if (parser.parse(c, file, name, vpCameraParameters::perspectiveProjWithDistortion,
                   static_cast<unsigned>(width_px),
                   static_cast<unsigned>(height_px)) != vpXmlParserCamera::SEQUENCE_OK)
    return false;
  camera = {c.get_px(), c.get_py(), c.get_u0(), c.get_v0(), c.get_kud(), c.get_kdu()};
  return true;
}

}  // namespace lineservo::support
