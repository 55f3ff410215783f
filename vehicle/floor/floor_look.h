#pragma once

#include "vehicle/floor/floor_light.h"
#include "vehicle/floor/repaint_options.h"
#include "vehicle/floor/wear_options.h"

namespace lineservo::vehicle {

/// What makes a painted floor look other than new and evenly lit.
struct FloorLook {
  WearOptions wear;
  RepaintOptions repaint;
  LightOptions light;
};

}  // namespace lineservo::vehicle
