#pragma once

#include <string>

#include "apps/config/camera/xml_reader.h"
#include "features/geometry/camera_model.h"

namespace lineservo::apps {

/// The camera of that name in the XML of ViSP's vpXmlParserCamera; an empty name is the only one. The model
/// with distortion is taken where there is one: its kud is k1 (kdu, an approximate inverse, is not used, as
/// CameraModel inverts exactly); else the one without. Throws InputError, also when the file has neither.
features::CameraParameters read_visp_camera(const XmlReader& xml, const std::string& name);

}  // namespace lineservo::apps
