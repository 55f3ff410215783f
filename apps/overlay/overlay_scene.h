#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>

#include "features/frame_features.h"
#include "features/geometry/level_view.h"
#include "features/mask/packed_mask.h"
#include "servo/plan/plan.h"
#include "servo/task/command.h"

namespace lineservo::apps {

/// Where the vehicle is on the floor: truth, which a simulation alone knows.
struct MapPose {
  Eigen::Vector2d p_W = Eigen::Vector2d::Zero();
  double heading_rad = 0.0;
};

/// What a picture shows of a tick. What is not there is not drawn.
struct OverlayScene {
  const cv::Mat* bgr = nullptr;  ///< none when the tick went on without a frame
  const features::PackedMask* mask = nullptr;
  features::FrameFeatures features;
  features::LevelView view, law_view;  ///< in which the features and the law's own lie
  servo::Command command;
  double time_s = 0.0;
  double height_m = 0.0;
  std::string phase;                         ///< empty when there is no plan
  std::optional<servo::NodeSignature> next;  ///< of the node that is expected
  std::optional<MapPose> vehicle;
};

}  // namespace lineservo::apps
