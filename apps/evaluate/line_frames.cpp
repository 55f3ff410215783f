#include "apps/evaluate/line_frames.h"

#include <opencv2/imgproc.hpp>

#include "apps/evaluate/degradations.h"
#include "features/geometry/angles.h"
#include "features/line/course_view.h"
#include "features/line/stripe_search.h"
#include "vehicle/floor/floor_renderer.h"
#include "vehicle/floor/image_noise.h"

namespace lineservo::apps {
namespace {

using features::PixelPoint;
using features::radians;
using vehicle::Random;

// What is drawn for one frame. The camera stands above the origin of W and looks along +x.
struct Scene {
  double height_m = 0.5, roll_rad = 0.0, pitch_rad = 0.0;
  bool has_line = true, has_branch = false;
  double width_m = 0.1;
  Eigen::Vector2d p_L = {0.0, 0.0};   // a point of the centreline
  Eigen::Vector2d d_L = {0.0, -1.0};  // its direction
  vehicle::Bgr paint = {}, floor = {};

  // Forward is −y and left is −x in L.
  Eigen::Vector2d on_floor(const Eigen::Vector2d& level) const {
    return {-level.y() * height_m, -level.x() * height_m};
  }
};

struct Amounts {
  double tilt_sigma_deg = 0.0;  // of what is told of the tilt
  double noise = 0.0, blur_px = 0.0, light_low = 1.0, light_high = 1.0;
  double wear = 0.0, gaps = 0.0, glare = 0.0, dirt = 0.0;
  int objects = 0, jpeg_quality = 100;
};

Amounts amounts_of(FrameLevel level) {
  switch (level) {
    case FrameLevel::clean:
      return {};
    case FrameLevel::real_like:
      return {.tilt_sigma_deg = 0.2,
              .noise = 3.0,
              .blur_px = 1.2,
              .light_low = 0.75,
              .light_high = 1.2,
              .wear = 0.05,
              .gaps = 0.3,
              .dirt = 0.01,
              .jpeg_quality = 85};
    case FrameLevel::harsh:
      return {.tilt_sigma_deg = 0.2,
              .noise = 6.0,
              .blur_px = 2.5,
              .light_low = 0.4,
              .light_high = 1.3,
              .wear = 0.25,
              .gaps = 1.0,
              .glare = 120.0,
              .dirt = 0.03,
              .objects = 4,
              .jpeg_quality = 50};
  }
  return {};
}

std::uint8_t level_in(Random& random, double low, double high) {
  return static_cast<std::uint8_t>(random.uniform(low, high));
}

Scene draw_scene(const features::CameraModel& camera, FrameLevel level, double empty, Random& random) {
  Scene scene;
  scene.height_m = random.uniform(0.4, 1.2);
  scene.roll_rad = radians(random.uniform(-10.0, 10.0));
  scene.pitch_rad = radians(random.uniform(-10.0, 10.0));
  scene.has_line = random.uniform() >= empty;
  const bool across = random.uniform() < 0.2;
  scene.has_branch = !across && random.uniform() < 0.25 && level != FrameLevel::clean;
  scene.width_m = std::min(random.uniform(0.05, 0.4), 0.6 * scene.height_m);
  const double yaw_rad = radians(across ? 90.0 + random.uniform(-20.0, 20.0) : random.uniform(-30.0, 30.0));
  scene.d_L = {std::sin(yaw_rad), -std::cos(yaw_rad)};
  const PixelPoint on_line{random.uniform(0.25, 0.75) * camera.width_px(),
                           random.uniform(0.25, 0.75) * camera.height_px()};
  const features::LevelView view(scene.roll_rad, scene.pitch_rad);
  scene.p_L = view.level(camera.normalize(on_line)).vector();
  const double grey = random.uniform(90.0, 150.0);
  for (auto& channel : scene.floor) channel = level_in(random, grey - 6.0, grey + 6.0);
  scene.paint = {level_in(random, 0.0, 40.0), level_in(random, 170.0, 215.0), level_in(random, 200.0, 240.0)};
  return scene;
}

vehicle::LayoutEdge edge(const vehicle::Layout& layout, std::size_t from, std::size_t to,
                         const Scene& scene) {
  return {.from = from,
          .to = to,
          .centreline = vehicle::Curve::line(layout.nodes[from].p_W, layout.nodes[to].p_W),
          .width_m = scene.width_m,
          .colour = scene.paint};
}

// A frame without a line stands far from its paint.
vehicle::Layout layout_of(const Scene& scene) {
  constexpr double reach = 12.0;  // heights: further than any of these cameras sees
  const Eigen::Vector2d away = scene.has_line ? Eigen::Vector2d(0.0, 0.0) : Eigen::Vector2d(500.0, 0.0);
  const Eigen::Vector2d side(-scene.d_L.y(), scene.d_L.x());
  vehicle::Layout layout;
  layout.name = "line";
  layout.floor_colour = scene.floor;
  layout.nodes = {{"back", scene.on_floor(scene.p_L - reach * scene.d_L) + away},
                  {"middle", scene.on_floor(scene.p_L) + away},
                  {"front", scene.on_floor(scene.p_L + reach * scene.d_L) + away}};
  layout.edges = {edge(layout, 0, 1, scene), edge(layout, 1, 2, scene)};
  if (scene.has_branch) {
    layout.nodes.push_back({"side", scene.on_floor(scene.p_L + reach * side) + away});
    layout.edges.push_back(edge(layout, 1, 3, scene));
  }
  return layout;
}

Eigen::Isometry3d camera_pose(const Scene& scene) {
  Eigen::Isometry3d X_WC = Eigen::Isometry3d::Identity();
  X_WC.linear() = features::tilt_R_HB(scene.roll_rad, scene.pitch_rad) * features::down_camera_R_BC();
  X_WC.translation().z() = scene.height_m;
  return X_WC;
}

cv::Scalar floor_scalar(const Scene& scene) {
  return {double(scene.floor[0]), double(scene.floor[1]), double(scene.floor[2])};
}

void draw_blot(cv::Mat& bgr, const PixelPoint& at, double radius_px, const cv::Scalar& colour,
               Random& random) {
  const cv::Size axes(1 + cvRound(16.0 * radius_px * random.uniform(0.5, 1.0)),
                      1 + cvRound(16.0 * radius_px));
  cv::ellipse(bgr, cv::Point(cvRound(16.0 * at.x), cvRound(16.0 * at.y)), axes, random.uniform(0.0, 180.0),
              0.0, 360.0, colour, cv::FILLED, cv::LINE_AA, 4);
}

// Blots of floor on the paint until about `share` of it is gone, of up to a quarter of its width and never
// more than 3 cm in radius.
void wear(cv::Mat& bgr, const LineFrame& frame, const Scene& scene, double share, Random& random) {
  const double focal_px = frame.camera.camera.parameters().fx_px;
  const double width = scene.width_m / scene.height_m;
  const double largest = std::min(0.03 / scene.height_m, 0.25 * width), length = 3.0;
  const double mean_area = features::kPi * 0.5 * largest * largest * 0.75;  // of r² uniform, axes 0.5…1
  const int blots = static_cast<int>(-std::log1p(-share) * length * width / mean_area);
  for (int k = 0; k < blots; ++k) {
    const Eigen::Vector2d across(-scene.d_L.y(), scene.d_L.x());
    const Eigen::Vector2d p = scene.p_L + random.uniform(-0.5, 0.5) * length * scene.d_L +
                              random.uniform(-0.5, 0.5) * width * across;
    const double radius_px = focal_px * largest * std::sqrt(random.uniform());
    draw_blot(bgr, project(frame.camera, p), radius_px, floor_scalar(scene), random);
  }
}

// A stretch of 3 to 10 cm without paint, straight across.
void gap(cv::Mat& bgr, const LineFrame& frame, const Scene& scene, Random& random) {
  const double half_long = 0.5 * random.uniform(0.03, 0.1) / scene.height_m;
  const double half_wide = 0.6 * scene.width_m / scene.height_m;
  const Eigen::Vector2d along = scene.d_L, across(-scene.d_L.y(), scene.d_L.x());
  const Eigen::Vector2d middle = scene.p_L + random.uniform(-1.0, 1.0) * along;
  std::vector<cv::Point> corners;
  for (const auto& [a, b] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
    const PixelPoint px = project(frame.camera, middle + a * half_long * along + b * half_wide * across);
    corners.emplace_back(cvRound(16.0 * px.x), cvRound(16.0 * px.y));
  }
  cv::fillConvexPoly(bgr, corners, floor_scalar(scene), cv::LINE_AA, 4);
}

void dirt(cv::Mat& bgr, double share, Random& random) {
  const double largest_px = 0.012 * bgr.cols;
  const int blots = static_cast<int>(share * bgr.cols * bgr.rows / (largest_px * largest_px));
  for (int k = 0; k < blots; ++k) {
    const double level = random.uniform(30.0, 90.0);
    const PixelPoint at{random.uniform(0.0, bgr.cols), random.uniform(0.0, bgr.rows)};
    draw_blot(bgr, at, largest_px * random.uniform(), {level, level, level}, random);
  }
}

// In the order in which it happens: on the floor, in the light, in the lens, on the sensor, in the file.
void degrade(LineFrame& frame, const Scene& scene, const Amounts& amounts, std::uint64_t noise_seed,
             Random& random) {
  cv::Mat& bgr = frame.bgr;
  if (scene.has_line && amounts.wear > 0.0) wear(bgr, frame, scene, amounts.wear, random);
  if (scene.has_line && random.uniform() < amounts.gaps) gap(bgr, frame, scene, random);
  if (amounts.dirt > 0.0) dirt(bgr, amounts.dirt, random);
  clutter(bgr, amounts.objects, random);
  if (amounts.light_low < amounts.light_high)
    uneven_light(bgr, amounts.light_low, amounts.light_high, random);
  if (amounts.glare > 0.0) specular_patch(bgr, amounts.glare, random);
  soften(bgr, random.uniform(0.3, 1.0) * amounts.blur_px);
  if (amounts.noise > 0.0) vehicle::ImageNoise(amounts.noise / 255.0, noise_seed).add(0, bgr);
  if (amounts.jpeg_quality < 100 && random.uniform() < 0.5) jpeg_blocks(bgr, amounts.jpeg_quality);
}

}  // namespace

std::string name_of(FrameLevel level) {
  switch (level) {
    case FrameLevel::clean:
      return "clean";
    case FrameLevel::real_like:
      return "real-like";
    case FrameLevel::harsh:
      return "harsh";
  }
  return "";
}

LineFrame make_line_frame(cv::Size size, FrameLevel level, std::uint64_t seed, int index, double empty) {
  const auto stream = static_cast<std::uint64_t>(index) * 8 + static_cast<std::uint64_t>(level);
  Random random(seed, stream);
  LineFrame frame{.bgr = {}, .camera = features::StripeSearch::assumed_camera(size), .truth = std::nullopt};
  const Scene scene = draw_scene(frame.camera.camera, level, empty, random);
  frame.camera.view = features::LevelView(scene.roll_rad, scene.pitch_rad);
  vehicle::FloorRenderer(layout_of(scene), frame.camera.camera).render(camera_pose(scene), frame.bgr);
  if (scene.has_line)
    frame.truth = features::line_through(project(frame.camera, scene.p_L - 0.1 * scene.d_L),
                                         project(frame.camera, scene.p_L + 0.1 * scene.d_L));
  const Amounts amounts = amounts_of(level);
  degrade(frame, scene, amounts, random.bits(), random);
  const double sigma_rad = radians(amounts.tilt_sigma_deg);
  frame.camera.view = features::LevelView(scene.roll_rad + random.normal(sigma_rad),
                                          scene.pitch_rad + random.normal(sigma_rad));
  return frame;
}

}  // namespace lineservo::apps
