#include "features/detect/image_detector.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "features/geometry/angles.h"
#include "features/line/line_methods.h"
#include "features/mask/mask_profile.h"

namespace lineservo::features {
namespace {

constexpr std::string_view kStripe = "stripe";
constexpr int kLeastSide_px = 16;
constexpr double kCarriesOn = 0.5;     // of the longest line, and of the surest one
constexpr double kSureBeside = 0.7;    // a line of another paint is told when it is so sure by itself
constexpr double kThinHue = 0.0035;    // of the image's width: the finer look sees lines from 4.5 px of 1280
constexpr double kWidestBeside = 2.5;  // and no wider than so many of the widest of the chosen paint

/// From mask pixels to pixels of the image; the resize keeps the corners of the pixels.
class ImageScale {
 public:
  ImageScale(cv::Size image, const MaskGeometry& mask)
      : image_(image),
        x_(static_cast<double>(image.width) / mask.width_px()),
        y_(static_cast<double>(image.height) / mask.height_px()) {}

  cv::Size image() const { return image_; }

  PixelPoint operator()(PixelPoint mask_px) const {
    return {(mask_px.x + 0.5) * x_ - 0.5, (mask_px.y + 0.5) * y_ - 0.5};
  }

 private:
  cv::Size image_;
  double x_, y_;
};

/// The part of a segment whose pixels are in the image. One that is wholly outside, as the middle of a broad
/// line of which a border alone is in view, stays as it is.
void clip(PixelPoint& begin, PixelPoint& end, cv::Size image) {
  PixelPoint from = begin, to = end;
  const auto keep_inside = [](double& x, double& y, double to_x, double to_y, double low, double high) {
    const double bound = std::clamp(x, low, high);
    if (bound == x || x == to_x) return;
    y += (bound - x) / (to_x - x) * (to_y - y);
    x = bound;
  };
  for (int way = 0; way < 2; ++way) {
    keep_inside(from.x, from.y, to.x, to.y, -0.5, image.width - 0.5);
    keep_inside(from.y, from.x, to.y, to.x, -0.5, image.height - 0.5);
    std::swap(from, to);
  }
  const auto is_inside = [&image](const PixelPoint& p) {
    constexpr double kBorder_px = -0.5, kRounding_px = 1e-6;
    return std::min(p.x, p.y) >= kBorder_px - kRounding_px &&
           p.x <= image.width + kBorder_px + kRounding_px && p.y <= image.height + kBorder_px + kRounding_px;
  };
  if (!is_inside(from) || !is_inside(to)) return;
  begin = from;
  end = to;
}

ImageLine in_image(const WedgeLine& line, const MaskGeometry& geometry, const ImageScale& scale) {
  const auto image_px = [&](double along, double across) {
    const Eigen::Vector2d p = StripeAxes(line.wedge.course).at(along, across);
    return scale(geometry.project({p.x(), p.y()}));
  };
  ImageLine px = line_through(image_px(line.begin, 0.0), image_px(line.end, 0.0));
  clip(px.begin, px.end, scale.image());
  const double middle = 0.5 * (line.begin + line.end), half = 0.5 * line.width_at(middle);
  const PixelPoint left = image_px(middle, -half), right = image_px(middle, half);
  px.width_px = std::hypot(right.x - left.x, right.y - left.y);
  px.quality = line.quality;
  return px;
}

/// The same paint seen in two colours, as yellow is also lighter than the floor.
bool is_among(const std::vector<ImageLine>& lines, const ImageLine& line) {
  const double x = 0.5 * (line.begin.x + line.end.x), y = 0.5 * (line.begin.y + line.end.y);
  return std::any_of(lines.begin(), lines.end(), [&](const ImageLine& other) {
    const double apart =
        std::abs(x * std::cos(other.theta_rad) + y * std::sin(other.theta_rad) - other.rho_px);
    return apart < other.width_px + line.width_px &&
           axis_difference(other.theta_rad, line.theta_rad) < radians(15.0);
  });
}

/// Lines that carry on go before pieces of a bend and stubs of side arms; apart from that the order stays,
/// which is the most nearly vertical first.
std::vector<WedgeLine> best_first(std::vector<WedgeLine> lines) {
  double longest = 0.0, surest = 0.0;
  for (const WedgeLine& line : lines) {
    longest = std::max(longest, line.length());
    surest = std::max(surest, line.evidence);
  }
  std::stable_partition(lines.begin(), lines.end(), [&](const WedgeLine& line) {
    return line.length() >= kCarriesOn * longest && line.evidence >= kCarriesOn * surest;
  });
  return lines;
}

/// A camera of twice the view for twice the pixels: what the search takes for narrow is a number of pixels.
/// None for a picture that is seen whole already, or by a known camera.
std::optional<MaskGeometry> finer_geometry(cv::Size image, const ImageDetectorOptions& options) {
  const int longest = std::max(image.width, image.height);
  const int finest = std::min(options.finest_side_px, longest);
  if (options.camera || finest <= options.longest_side_px) return std::nullopt;
  const auto scaled = [&](int side_px) {
    return std::max(kLeastSide_px, static_cast<int>(std::lround(1.0 * side_px * finest / longest)));
  };
  CameraParameters camera{.width_px = scaled(image.width), .height_px = scaled(image.height)};
  camera.fx_px = camera.fy_px = 0.5 * camera.width_px * options.longest_side_px / finest;
  camera.cx_px = 0.5 * (camera.width_px - 1);
  camera.cy_px = 0.5 * (camera.height_px - 1);
  return MaskGeometry(CameraModel(camera), camera.width_px, camera.height_px);
}

double widest_px(const std::vector<ImageLine>& lines) {
  double widest = 0.0;
  for (const ImageLine& line : lines) widest = std::max(widest, line.width_px);
  return widest;
}

/// The lines besides those of the chosen paint, such as white ones beside a yellow one.
void add_other_paints(const std::vector<ColorChoice>& paints, const MaskGeometry& geometry,
                      const ImageScale& scale, std::vector<ImageLine>& lines) {
  const double widest = kWidestBeside * widest_px(lines);
  for (std::size_t k = 1; k < paints.size(); ++k) {
    for (const WedgeLine& line : paints[k].seen.lines) {
      const ImageLine px = in_image(line, geometry, scale);
      if (line.evidence >= kSureBeside && px.width_px <= widest && !is_among(lines, px)) lines.push_back(px);
    }
  }
}

}  // namespace

ImageDetector::ImageDetector(const ImageDetectorOptions& options)
    : options_(options), segmenter_(options.segmenter) {
  find_line_method(options.method);
  if (options.longest_side_px < 64 || options.longest_side_px > 4096)
    throw std::invalid_argument("image detector: longest_side_px must be 64 to 4096");
  if (options.finest_side_px < 64 || options.finest_side_px > 4096)
    throw std::invalid_argument("image detector: finest_side_px must be 64 to 4096");
  if (options.camera) CameraModel{*options.camera};
}

ImageDetection ImageDetector::detect(const cv::Mat& image) const {
  require_segmentable(image, {kLeastSide_px, kLeastSide_px});
  const MaskGeometry geometry = geometry_for(image.size());
  const std::vector<ColorChoice> paints = segmenter_.choices(image, geometry);
  if (!paints.empty()) return told(paints, image, geometry);
  const auto finer = finer_geometry(image.size(), options_);
  if (!finer) return {};
  const std::vector<ColorChoice> thin = thin_paints(image, *finer);
  return thin.empty() ? ImageDetection() : told(thin, image, *finer);
}

// White and black are left out: so thin, they are joints between tiles and planks.
std::vector<ColorChoice> ImageDetector::thin_paints(const cv::Mat& image,
                                                    const MaskGeometry& geometry) const {
  AutoSegmenterOptions options = options_.segmenter;
  std::erase_if(options.colors, [](LineColor c) { return c == LineColor::white || c == LineColor::black; });
  if (options.colors.empty() || image.channels() == 1) return {};
  options.least_hue_width = kThinHue;
  return AutoSegmenter(options).choices(image, geometry);
}

ImageDetection ImageDetector::told(const std::vector<ColorChoice>& paints, const cv::Mat& image,
                                   const MaskGeometry& geometry) const {
  ImageDetection detection;
  const ColorChoice& best = paints.front();
  const ImageScale scale(image.size(), geometry);
  detection.color = best.color;
  detection.evidence = best.evidence;
  detection.code = best.seen.code;
  if (best.seen.junction) {
    const LevelPoint centre = best.seen.junction->centre;
    detection.junction_px = scale(geometry.project({centre.x, centre.y}));
  }
  const MaskProfile profile = profile_of(best.mask);
  detection.foreground_ratio = foreground_ratio(profile);
  if (const auto centre = centroid(profile)) detection.centroid_px = scale(*centre);
  detection.lines = lines_of(best, image, geometry);
  if (options_.method == kStripe) add_other_paints(paints, geometry, scale, detection.lines);
  return detection;
}

// The search for the colour has found the stripes already; the other methods look at its mask, or at the
// image itself.
std::vector<ImageLine> ImageDetector::lines_of(const ColorChoice& paint, const cv::Mat& image,
                                               const MaskGeometry& geometry) const {
  std::vector<ImageLine> lines;
  if (options_.method == kStripe) {
    const ImageScale scale(image.size(), geometry);
    for (const WedgeLine& line : best_first(paint.seen.lines))
      lines.push_back(in_image(line, geometry, scale));
    return lines;
  }
  const std::unique_ptr<LineDetector> detector = find_line_method(options_.method).make();
  for (const DetectedLine& line : detector->detect({image, paint.mask})) lines.push_back(line.image);
  return lines;
}

MaskGeometry ImageDetector::geometry_for(cv::Size image_size) const {
  const double scale = std::min(
      1.0, options_.longest_side_px / static_cast<double>(std::max(image_size.width, image_size.height)));
  const auto scaled = [scale](int side_px) {
    return std::max(kLeastSide_px, static_cast<int>(std::lround(scale * side_px)));
  };
  const int width_px = scaled(image_size.width), height_px = scaled(image_size.height);
  if (!options_.camera) return assumed_geometry(width_px, height_px);
  const CameraParameters& camera = *options_.camera;
  if (image_size.width != camera.width_px || image_size.height != camera.height_px)
    throw std::invalid_argument("the image is " + std::to_string(image_size.width) + "×" +
                                std::to_string(image_size.height) + " px, the camera " +
                                std::to_string(camera.width_px) + "×" + std::to_string(camera.height_px));
  return {CameraModel(camera), width_px, height_px};
}

}  // namespace lineservo::features
