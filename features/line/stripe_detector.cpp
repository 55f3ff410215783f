#include "features/line/stripe_detector.h"

#include "features/line/course_view.h"
#include "features/line/level_line.h"
#include "features/line/scene_check.h"

namespace lineservo::features {

DetectedLine view_stripe(const Stripe& stripe, const CameraPose& pose) {
  const StripeAxes axes(stripe.course);
  const double foot = axes.along(stripe.feature.begin.vector());
  CurvedFit fit{.course = CurvedCourse::straight(stripe.course, foot)};
  DetectedLine line =
      view_course(fit, {0.0, axes.along(stripe.feature.end.vector()) - foot}, pose, stripe.feature.quality);
  line.level = stripe.feature;
  line.image.covariance = image_covariance(line.image, stripe.feature.covariance, pose);
  return line;
}

std::vector<DetectedLine> StripeDetector::detect(const LineScene& scene) {
  require_image(scene.image);
  if (!is_large_enough(scene.image)) return {};
  const CameraPose pose = scene.camera ? *scene.camera : StripeSearch::assumed_camera(scene.image.size());
  std::vector<DetectedLine> lines;
  for (const Stripe& stripe : search_.find(scene.mask, pose, scene.prior)) {
    lines.push_back(view_stripe(stripe, pose));
    if (!scene.camera) lines.back().level.reset();
  }
  return lines;
}

}  // namespace lineservo::features
