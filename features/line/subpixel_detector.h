#pragma once

#include "features/line/border_refiner.h"
#include "features/line/line_detector.h"
#include "features/line/stripe_search.h"

namespace lineservo::features {

/// `subpixel` (ours): the stripes of the mask, refined on the image. A stripe that the image does not show
/// clearly enough stays as the mask has it, at half its quality.
class SubpixelDetector final : public LineDetector {
 public:
  explicit SubpixelDetector(const RefinerOptions& options = {}) : refiner_(options) {}

  cv::Size mask_size(cv::Size image) const override { return StripeSearch::mask_size(image); }
  std::vector<DetectedLine> detect(const LineScene& scene) override;

 private:
  DetectedLine refined(const Stripe& stripe, const LineScene& scene, const CameraPose& pose) const;

  StripeSearch search_;
  BorderRefiner refiner_;
};

}  // namespace lineservo::features
