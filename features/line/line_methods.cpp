#include "features/line/line_methods.h"

#include <array>
#include <stdexcept>
#include <string>

#include "features/line/centroid_detector.h"
#include "features/line/combined_detector.h"
#include "features/line/fitline_detector.h"
#include "features/line/naive_detector.h"
#include "features/line/skeleton_detector.h"
#include "features/line/slices_detector.h"
#include "features/line/stripe_detector.h"
#include "features/line/subpixel_detector.h"

namespace lineservo::features {
namespace {

template <typename Detector>
std::unique_ptr<LineDetector> make() {
  return std::make_unique<Detector>();
}

constexpr std::array<LineMethod, 8> kMethods = {{
    {"naive", "Canny edges and Hough transform", false, make<NaiveDetector>},
    {"centroid", "moments of the mask", false, make<CentroidDetector>},
    {"slices", "contour centroids in slices, RANSAC (grid, Alg. 1)", false, make<SlicesDetector>},
    {"fitline", "M-estimator least squares (lfpf §3.3.3)", false, make<FitlineDetector>},
    {"skeleton", "Zhang-Suen, Hough, clusters in rho and theta (grid §IV-B2)", false, make<SkeletonDetector>},
    {"combined", "slices and skeleton fused (grid §IV-B2)", false, make<CombinedDetector>},
    {"stripe", "both borders of every stripe, on the mask (ours)", true, make<StripeDetector>},
    {"subpixel", "the stripes' borders to a fraction of a pixel, on the image (ours)", true,
     make<SubpixelDetector>},
}};

}  // namespace

std::span<const LineMethod> line_methods() {
  return kMethods;
}

const LineMethod& find_line_method(std::string_view name) {
  std::string names;
  for (const LineMethod& method : kMethods) {
    if (method.name == name) return method;
    names += (names.empty() ? "" : ", ") + std::string(method.name);
  }
  throw std::invalid_argument("line method '" + std::string(name) + "' is not one of " + names);
}

}  // namespace lineservo::features
