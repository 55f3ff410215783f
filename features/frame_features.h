#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "features/geometry/points.h"
#include "features/junction/junction_code.h"

namespace lineservo::features {

/// The centreline of a painted stripe in the virtual level camera, x cosθ + y sinθ − ρ = 0.
/// Lengths are in normalised units: times the height they are metres on the floor.
struct LineFeature {
  double rho = 0.0;
  double theta_rad = 0.0;                                    ///< in (−π/2, π/2]
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Identity();  ///< of (ρ, θ)
  double width = 0.0;                                        ///< of the stripe
  double quality = 0.0;    ///< share of the visible border that supports it, 0…1
  LevelPoint begin, end;   ///< where the centreline starts and ends in view; end is forward
  double curvature = 0.0;  ///< positive: bends towards the normal; 0 unless measured and significant
};

/// One painted arm that leaves a junction.
struct ArmFeature {
  double angle_rad = 0.0;  ///< from the vehicle's forward, counter-clockwise seen from above, in (−π, π]
  double length = 0.0;     ///< visible length beyond the node, normalised units
};

/// A place where stripes meet, in the virtual level camera.
struct JunctionFeature {
  LevelPoint centre;  ///< crossing of the centrelines; may lie out of view
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Identity();  ///< of the centre
  std::vector<ArmFeature> arms;
  double quality = 0.0;  ///< 0…1
};

/// What a recogniser says of one frame, before and after the temporal filter (topology §2.5).
struct CodeReading {
  JunctionCode raw = JunctionCode::unrecognised;
  JunctionCode held = JunctionCode::unrecognised;      ///< J1 replaced by the last smoothed code
  JunctionCode smoothed = JunctionCode::unrecognised;  ///< mode of the window
  bool line_ends_ahead =
      false;  ///< the stripe that is followed stops inside the image: a corner or a ┬, not a preview
};

/// What only some laws look at; perception fills in what FeatureNeeds asks for. Points and lines lie in the
/// level camera or, where the needs say so, in the camera as it hangs.
struct LawFeatures {
  std::optional<LevelPoint> centroid;       ///< of the path mask (topology §2.3)
  std::vector<LineFeature> lines;           ///< by the line method of the law's own paper
  std::optional<LevelPoint> ahead, behind;  ///< where the path leaves and enters the frame (lfpf §3.3.2)
  std::optional<LevelPoint> target;         ///< the virtual target point (vtp §3.1)
};

/// Everything that perception says of one frame. What was not seen is absent, never stale.
struct FrameFeatures {
  std::vector<LineFeature> lines;           ///< every stripe in view, best to follow first
  std::optional<JunctionFeature> junction;  ///< the one nearest to the image centre
  CodeReading code;
  /// Where the line to follow stops with bare floor beyond it, however little: it may be worn paint.
  std::optional<LevelPoint> line_end;
  std::optional<PixelPoint> centroid_px;   ///< of the path mask, in the resized 400×400 frame
  int marker_pixels = 0;                   ///< red pixels of the start marker, in the resized frame
  std::optional<LevelPoint> start_marker;  ///< its centroid, when there are enough of them for J0
  double foreground_ratio = 0.0;           ///< share of the frame that is path
  LawFeatures law;

  /// The line to follow, or none.
  const LineFeature* line() const { return lines.empty() ? nullptr : &lines.front(); }
};

}  // namespace lineservo::features
