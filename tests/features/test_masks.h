#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "features/geometry/angles.h"
#include "features/geometry/level_view.h"
#include "features/junction/junction_code.h"
#include "features/line/stripe.h"
#include "features/mask/mask_geometry.h"
#include "features/mask/mask_view.h"

/// Masks of painted floors with exact ground truth, drawn pixel centre by pixel centre. For tests alone.
namespace lineservo::features::test {

inline constexpr int kMaskSize = 400;

/// A mask that owns its words.
class TestMask {
 public:
  TestMask(int width, int height)
      : width_(width),
        height_(height),
        stride_((width + 63) / 64),
        words_(static_cast<std::size_t>(stride_ * height), 0) {}

  void set(int x, int y, bool on) {
    std::uint64_t& word = words_[static_cast<std::size_t>(y * stride_ + x / 64)];
    const std::uint64_t bit = std::uint64_t{1} << (x % 64);
    word = on ? word | bit : word & ~bit;
  }
  bool at(int x, int y) const { return view().at(x, y); }
  MaskView view() const { return {width_, height_, stride_, words_.data()}; }

 private:
  int width_, height_, stride_;
  std::vector<std::uint64_t> words_;
};

/// SplitMix64 (Steele, Lea and Flood): enough for tests, the same everywhere.
class TestRandom {
 public:
  explicit TestRandom(std::uint64_t seed) : state_(seed) {}
  std::uint64_t bits() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(bits() >> 11) * 0x1p-53;
  }

 private:
  std::uint64_t state_;
};

/// A painted rectangle around the segment from a to b, in floor metres.
class Strip {
 public:
  Strip(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double width)
      : a_(a), along_((b - a).normalized()), length_((b - a).norm()), half_width_(0.5 * width) {}

  bool covers(const Eigen::Vector2d& p) const {
    const Eigen::Vector2d from_a = p - a_;
    const double t = from_a.dot(along_);
    return t >= 0.0 && t <= length_ &&
           std::abs(along_.x() * from_a.y() - along_.y() * from_a.x()) <= half_width_;
  }

 private:
  Eigen::Vector2d a_, along_;
  double length_, half_width_;
};

/// A node at the origin of the floor with arms that leave it, headings counter-clockwise from +x.
struct Floor {
  std::vector<Strip> strips;
  std::vector<double> arm_headings_rad;
  double arm_length = 0.0;
  double width = 0.0;

  bool covers(const Eigen::Vector2d& p) const {
    return std::any_of(strips.begin(), strips.end(), [&p](const Strip& s) { return s.covers(p); });
  }
};

/// Arms from a node whose square is filled.
inline Floor node_floor(const std::vector<double>& arm_headings_rad, double width, double arm_length = 5.0) {
  Floor floor{.strips = {}, .arm_headings_rad = arm_headings_rad, .arm_length = arm_length, .width = width};
  for (const double heading : arm_headings_rad) {
    const Eigen::Vector2d out(std::cos(heading), std::sin(heading));
    floor.strips.push_back({-0.5 * width * out, arm_length * out, width});
  }
  return floor;
}

inline constexpr double kAhead = 0.0, kLeft = kPi / 2.0, kRight = -kPi / 2.0, kBehind = kPi;

inline Floor straight_floor(double width) {
  return node_floor({kAhead, kBehind}, width);
}

/// Where the vehicle stands: position on the floor, height, heading, attitude.
struct Pose {
  double x_m = 0.0, y_m = 0.0, height_m = 0.5, heading_rad = 0.0, roll_rad = 0.0, pitch_rad = 0.0;

  LevelView view() const { return {roll_rad, pitch_rad}; }
  /// The floor point that a level point shows: forward is −y_L and left is −x_L, times the height.
  Eigen::Vector2d floor(const Eigen::Vector2d& p_L) const {
    return Eigen::Vector2d(x_m, y_m) +
           Eigen::Rotation2Dd(heading_rad) * Eigen::Vector2d(-p_L.y() * height_m, -p_L.x() * height_m);
  }
  Eigen::Vector2d level(const Eigen::Vector2d& p_W) const {
    const Eigen::Vector2d p = Eigen::Rotation2Dd(-heading_rad) * (p_W - Eigen::Vector2d(x_m, y_m));
    return Eigen::Vector2d(-p.y(), -p.x()) / height_m;
  }
};

/// The ray of a pixel's centre in the camera; without a lens the pinhole is all of it, and much quicker.
inline Eigen::Vector3d pixel_ray(const MaskGeometry& geometry, int x, int y) {
  const Eigen::Matrix3d& K_inverse = geometry.pinhole_inverse();
  if (!geometry.has_distortion())
    return {K_inverse(0, 0) * x + K_inverse(0, 2), K_inverse(1, 1) * y + K_inverse(1, 2), 1.0};
  const NormalizedPoint n = geometry.normalize({static_cast<double>(x), static_cast<double>(y)});
  return {n.x, n.y, 1.0};
}

/// Calls each(x, y, floor point) for every mask pixel, by its own ray through the tilted camera.
template <typename Each>
void for_each_pixel(const MaskGeometry& geometry, const Pose& pose, Each&& each) {
  const Eigen::Matrix3d R_WC =
      Eigen::AngleAxisd(pose.heading_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix() *
      tilt_R_HB(pose.roll_rad, pose.pitch_rad) * down_camera_R_BC();
  for (int y = 0; y < geometry.height_px(); ++y) {
    for (int x = 0; x < geometry.width_px(); ++x) {
      const Eigen::Vector3d ray = R_WC * pixel_ray(geometry, x, y);
      const double scale = -pose.height_m / ray.z();
      each(x, y, Eigen::Vector2d(pose.x_m + scale * ray.x(), pose.y_m + scale * ray.y()));
    }
  }
}

inline TestMask draw(const MaskGeometry& geometry, const Pose& pose, const Floor& floor) {
  TestMask mask(geometry.width_px(), geometry.height_px());
  for_each_pixel(geometry, pose, [&](int x, int y, const Eigen::Vector2d& p) {
    if (floor.covers(p)) mask.set(x, y, true);
  });
  return mask;
}

/// Clears (or paints) discs of up to `radius_px` until about `share` of the picture is covered.
inline void blot(TestMask& mask, TestRandom& random, double share, double radius_px, bool on) {
  const MaskView view = mask.view();
  const double mean_area = kPi * radius_px * radius_px / 3.0;
  const int discs = static_cast<int>(-std::log1p(-share) * view.width * view.height / mean_area);
  for (int k = 0; k < discs; ++k) {
    const double cx = random.uniform(0.0, view.width), cy = random.uniform(0.0, view.height);
    const double r = random.uniform(0.0, radius_px);
    for (int y = std::max(0, static_cast<int>(cy - r)); y < std::min(view.height, static_cast<int>(cy + r));
         ++y)
      for (int x = std::max(0, static_cast<int>(cx - r)); x < std::min(view.width, static_cast<int>(cx + r));
           ++x)
        if (std::hypot(x - cx, y - cy) < r) mask.set(x, y, on);
  }
}

/// Flips each pixel with the given probability.
inline void add_noise(TestMask& mask, TestRandom& random, double probability) {
  const MaskView view = mask.view();
  for (int y = 0; y < view.height; ++y)
    for (int x = 0; x < view.width; ++x)
      if (random.uniform(0.0, 1.0) < probability) mask.set(x, y, !mask.at(x, y));
}

/// The true course of the line through a floor point with a heading, θ in (−π/2, π/2].
inline StripeCourse true_course(const Pose& pose, const Eigen::Vector2d& p_W, double heading_rad,
                                double width_m) {
  const Eigen::Vector2d a = pose.level(p_W);
  const Eigen::Vector2d b = pose.level(p_W + Eigen::Vector2d(std::cos(heading_rad), std::sin(heading_rad)));
  const Eigen::Vector2d d = (b - a).normalized();
  StripeCourse course{.theta_rad = std::atan2(-d.x(), d.y()), .rho = 0.0, .width = width_m / pose.height_m};
  if (course.theta_rad > kPi / 2.0) course.theta_rad -= kPi;
  if (course.theta_rad <= -kPi / 2.0) course.theta_rad += kPi;
  course.rho = a.dot(course.normal());
  return course;
}

/// The signed differences (ρ, θ) with the branch (−ρ, θ + π) taken where it is the nearer one.
inline Eigen::Vector2d course_error(double rho, double theta_rad, const StripeCourse& truth) {
  const double turn = wrap_angle(theta_rad - truth.theta_rad);
  if (std::abs(turn) <= kPi / 2.0) return {rho - truth.rho, turn};
  return {-rho - truth.rho, wrap_angle(turn + kPi)};
}

/// The code of codes.md for the node at the origin, and by how many pixels its closest call was decided.
struct CodeTruth {
  JunctionCode code = JunctionCode::unrecognised;
  double margin_px = std::numeric_limits<double>::infinity();
};

/// The sizes in pixels of what is in view of each arm beyond the node's square, by looking at every pixel.
inline std::vector<Eigen::Vector2d> true_arm_sizes_px(const MaskGeometry& geometry, const Pose& pose,
                                                      const Floor& floor) {
  struct Seen {
    Strip strip;
    Eigen::Vector2d low{1e9, 1e9}, high{-1e9, -1e9};
  };
  std::vector<Seen> arms;
  for (const double heading : floor.arm_headings_rad) {
    const Eigen::Vector2d out(std::cos(heading), std::sin(heading));
    arms.push_back({.strip = {0.5 * floor.width * out, floor.arm_length * out, floor.width}});
  }
  for_each_pixel(geometry, pose, [&arms](int x, int y, const Eigen::Vector2d& p) {
    for (Seen& arm : arms) {
      if (!arm.strip.covers(p)) continue;
      arm.low = arm.low.cwiseMin(Eigen::Vector2d(x, y));
      arm.high = arm.high.cwiseMax(Eigen::Vector2d(x, y));
    }
  });
  std::vector<Eigen::Vector2d> sizes;
  sizes.reserve(arms.size());
  for (const Seen& arm : arms)
    sizes.push_back((arm.high - arm.low + Eigen::Vector2d(1.0, 1.0)).cwiseMax(0.0));
  return sizes;
}

inline CodeTruth true_code(const MaskGeometry& geometry, const Pose& pose, const Floor& floor) {
  Arms arms;
  CodeTruth truth;
  const std::vector<Eigen::Vector2d> sizes = true_arm_sizes_px(geometry, pose, floor);
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    const double shorter_px = sizes[k].minCoeff();
    truth.margin_px = std::min(truth.margin_px, std::abs(shorter_px - 20.0));
    if (shorter_px < 20.0) continue;
    const double angle = wrap_angle(floor.arm_headings_rad[k] - pose.heading_rad);
    const int quarter = static_cast<int>(std::lround(angle / (kPi / 2.0)));
    if (quarter == 0)
      arms.forward = true;
    else if (quarter == 1)
      arms.left = true;
    else if (quarter == -1)
      arms.right = true;
    else
      arms.back = true;
  }
  truth.code = arms == Arms{} ? JunctionCode::straight : code_of(arms);
  return truth;
}

}  // namespace lineservo::features::test
