#pragma once

#include "features/line/line_detector.h"
#include "features/line/stripe_search.h"

namespace lineservo::features {

/// `stripe` (ours): both borders of every stripe, fitted on the mask. Where the camera is known the borders
/// are parallel in the level camera, else in the image.
class StripeDetector final : public LineDetector {
 public:
  cv::Size mask_size(cv::Size image) const override { return StripeSearch::mask_size(image); }
  std::vector<DetectedLine> detect(const LineScene& scene) override;

 private:
  StripeSearch search_;
};

/// A stripe as the finder gave it, in the image and in the level camera.
DetectedLine view_stripe(const Stripe& stripe, const CameraPose& pose);

}  // namespace lineservo::features
