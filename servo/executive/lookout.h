#pragma once

#include <string>
#include <vector>

#include "servo/law/observation.h"

namespace lineservo::servo {

/// What the camera saw while the vehicle turned about itself over a node.
class Lookout {
 public:
  Lookout() = default;
  /// Headings are of the dead reckoning; arms are told against this one.
  explicit Lookout(double heading_rad) : heading_rad_(heading_rad) {}

  void observe(const Observation& observation);
  /// The arms that half of the frames with a junction below the vehicle agree on, counter-clockwise from the
  /// heading, from the right to the back, in order.
  std::vector<double> arms_rad() const;
  /// "junction with arms at -90°, 0°, 180°; red disc", or "no junction".
  std::string told() const;

 private:
  struct Arm {
    double angle_rad;  ///< mean
    int frames;
  };
  void add(double angle_rad);

  double heading_rad_ = 0.0;
  int junctions_ = 0, discs_ = 0, frames_ = 0;
  std::vector<Arm> arms_;
};

}  // namespace lineservo::servo
