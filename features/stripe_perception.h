#pragma once

#include <optional>
#include <vector>

#include "features/frame_features.h"
#include "features/junction/stripe_junction.h"
#include "features/junction/visible_arms.h"
#include "features/line/border_points.h"
#include "features/line/stripe_bend.h"
#include "features/line/stripe_finder.h"
#include "features/mask/level_mask.h"

namespace lineservo::features {

/// Options of every step from the mask to stripes and junction. Lengths in normalised units.
struct StripePerceptionOptions {
  BorderOptions border = {};
  StripeOptions stripe = {};
  BendOptions bend = {};
  JunctionOptions junction = {};
  ArmVisibility visibility = {};
  double certain_end = 0.45;   ///< bare floor past the end of a stripe that shows, by itself, that it stops
  double junction_end = 0.12;  ///< bare floor beyond a node that shows that the line stops there, at least
  double clear_end = 0.5;      ///< from the node's centre: up to here it is looked for where there is room
  double possible_end = 0.04;  ///< bare floor past a stripe that may be its end, or worn paint
};

/// What the stripes of one frame say.
struct StripeFeatures {
  std::vector<LineFeature> lines;           ///< every stripe in view, best to follow first
  std::optional<JunctionFeature> junction;  ///< the one nearest to the image centre
  Arms arms;                                ///< of the junction, those visible by the code rule
  JunctionCode raw = JunctionCode::unrecognised;
  bool line_ends_ahead = false;
  std::optional<LevelPoint> line_end;  ///< as in FrameFeatures
};

/// From a mask of the path to stripes, junction and code. Remembers nothing but its buffers from frame to
/// frame: the same mask, view and prior give the same answer.
class StripePerception {
 public:
  /// Throws std::invalid_argument for options out of bounds.
  explicit StripePerception(const MaskGeometry& geometry, const StripePerceptionOptions& options = {});

  /// Throws std::invalid_argument unless the mask has the size of the geometry. The answer holds until the
  /// next call.
  const StripeFeatures& observe(const MaskView& mask, const LevelView& view,
                                const std::optional<StripePrior>& prior = std::nullopt);

  /// The border points that the last answer rests on, for overlays.
  const std::vector<BorderPoint>& border_points() const { return points_; }

 private:
  bool stops_at(const LevelMask& mask, const JunctionFeature& junction) const;
  bool ends_ahead(const LevelMask& mask, const std::optional<StripeJunction>& junction) const;
  bool goes_on(const std::optional<StripeJunction>& junction, double within_rad) const;
  JunctionCode code() const;

  MaskGeometry geometry_;
  StripePerceptionOptions options_;
  BorderExtractor border_;
  StripeFinder stripe_finder_;
  JunctionFinder junction_finder_;
  std::vector<BorderPoint> points_;
  std::vector<Stripe> stripes_;
  StripeFeatures features_;
};

}  // namespace lineservo::features
