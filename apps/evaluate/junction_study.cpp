#include "apps/evaluate/junction_study.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "apps/config/layout_topology.h"
#include "apps/scoring/junction_truth.h"
#include "apps/scoring/route_truth.h"
#include "features/geometry/angles.h"
#include "servo/executive/junction_matcher.h"
#include "vehicle/floor/floor_renderer.h"
#include "vehicle/floor/image_noise.h"
#include "vehicle/random.h"

namespace lineservo::apps {
namespace {

using features::radians;

constexpr double kCorrelation_s = 0.5;
constexpr double kSpeed_m_s = 0.1;
constexpr double kStart_m = 0.2;        // of a leg: what lies before belongs to the turn
constexpr double kTurnBefore_m = 0.05;  // of a node where the way turns
constexpr int kConfirmFrames = 2;

/// First-order Gauss–Markov noise, stepped once a frame.
class Jitter {
 public:
  Jitter(double sigma, double period_s) : sigma_(sigma), keep_(std::exp(-period_s / kCorrelation_s)) {}
  double next(vehicle::Random& random) {
    value_ = keep_ * value_ + std::sqrt(1.0 - keep_ * keep_) * random.normal(sigma_);
    return value_;
  }

 private:
  double sigma_, keep_, value_ = 0.0;
};

/// The camera's carrier: follows a leg with jitter.
class Carrier {
 public:
  Carrier(const JunctionStudyOptions& o, vehicle::Random& random)
      : height_m_(o.height_m),
        random_(random),
        yaw_(radians(o.yaw_sigma_deg), o.step_m / kSpeed_m_s),
        roll_(radians(o.tilt_sigma_deg), o.step_m / kSpeed_m_s),
        pitch_(roll_),
        offset_(o.offset_sigma_m, o.step_m / kSpeed_m_s) {}

  /// The pose at a point of the way; also sets roll and pitch.
  Eigen::Isometry3d at(const vehicle::CurvePoint& point) {
    roll_rad = roll_.next(random_);
    pitch_rad = pitch_.next(random_);
    const double heading_rad = point.heading_rad + yaw_.next(random_), left_m = offset_.next(random_);
    const Eigen::Vector2d left(-std::sin(point.heading_rad), std::cos(point.heading_rad));
    Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
    X_WB.linear() = Eigen::AngleAxisd(heading_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix() *
                    features::tilt_R_HB(roll_rad, pitch_rad);
    X_WB.translation() << point.p_W + left_m * left, height_m_;
    return X_WB;
  }

  double roll_rad = 0.0, pitch_rad = 0.0;

 private:
  double height_m_;
  vehicle::Random& random_;
  Jitter yaw_, roll_, pitch_, offset_;
};

/// One recogniser with a filter and a matcher for each window.
class Recogniser {
 public:
  Recogniser(const features::CameraModel& camera, features::JunctionMethod method, std::string name)
      : perception_(camera, options(method)) {
    score.method = std::move(name);
  }

  void begin_leg() {
    for (std::size_t w = 0; w < kWindows.size(); ++w) {
      filters_[w] = features::CodeFilter(kWindows[w]);
      matchers_[w].restart();
    }
    travelled_m_ = 0.0;
    told_m_.fill(0.0);
  }

  void see(const cv::Mat& frame, const features::LevelView& view, const CodeTruth& truth, double step_m) {
    const auto begin = std::chrono::steady_clock::now();
    const features::FrameFeatures seen = perception_.observe(frame, {view, 0.5, 0.0});
    spent_s_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    travelled_m_ += step_m;
    if (truth.scored) count(seen.code.raw, truth);
    for (std::size_t w = 0; w < kWindows.size(); ++w) {
      const features::CodeReading reading = filters_[w].update(seen.code.raw, seen.code.line_ends_ahead);
      if (truth.scored && !truth.accepts(reading.smoothed)) ++score.smoothed_wrong[w];
      const bool away = travelled_m_ - told_m_[w] > 0.35;
      if (const auto node = matchers_[w].update(reading, away)) tell(w, *node);
    }
  }

  /// The node that the way comes to next, or none any more.
  void expect(const servo::NodeSignature* node) {
    expected_ = node;
    told_.fill(false);
  }

  void finish() {
    score.perception_ms = score.frames == 0 ? 0.0 : 1000.0 * spent_s_ / static_cast<double>(score.frames);
  }

  RecogniserScore score;

 private:
  static features::PerceptionOptions options(features::JunctionMethod method) {
    features::PerceptionOptions o;
    o.junction_method = method;
    o.junction_window = 1;
    return o;
  }

  void count(features::JunctionCode raw, const CodeTruth& truth) {
    ++score.frames;
    score.ambiguous += truth.ambiguous() ? 1 : 0;
    score.raw_wrong += truth.accepts(raw) ? 0 : 1;
    const auto true_code = truth.accepts(raw) ? raw : truth.code;
    ++score.confusion[static_cast<std::size_t>(true_code)][static_cast<std::size_t>(raw)];
  }

  void tell(std::size_t window, const servo::NodeSighting& node) {
    told_m_[window] = travelled_m_;
    const bool right =
        expected_ && !told_[window] && node.code == expected_->code && node.line_ends == expected_->line_ends;
    if (right) {
      told_[window] = true;
      ++score.events_right[window];
    } else if (kWindows[window] == features::CodeFilter::kDefaultWindow) {
      ++score.events_false;
    }
  }

  features::Perception perception_;
  std::array<features::CodeFilter, kWindows.size()> filters_;
  std::array<servo::JunctionMatcher, kWindows.size()> matchers_ = {
      servo::JunctionMatcher(kConfirmFrames), servo::JunctionMatcher(kConfirmFrames),
      servo::JunctionMatcher(kConfirmFrames), servo::JunctionMatcher(kConfirmFrames)};
  std::array<double, kWindows.size()> told_m_ = {};
  std::array<bool, kWindows.size()> told_ = {};
  const servo::NodeSignature* expected_ = nullptr;
  double travelled_m_ = 0.0, spent_s_ = 0.0;
};

/// Where a node that is told must lie, from the node: seen ahead at half the view, told until it is under the
/// camera.
constexpr double kSeen_m = 0.6;

vehicle::FloorLook worn(const vehicle::WearOptions& wear) {
  vehicle::FloorLook look;
  look.wear = wear;
  return look;
}

/// One route: its steps by the edges that lead to them.
class RouteStudy {
 public:
  RouteStudy(const vehicle::Layout& layout, const JunctionStudyOptions& options,
             std::vector<Recogniser>& recognisers)
      : options_(options),
        camera_(features::CameraParameters{}),
        renderer_(layout, camera_, worn(options.wear), options.seed),
        truth_(layout, camera_),
        noise_(options.noise_levels / 255.0, options.seed),
        random_(options.seed),
        carrier_(options, random_),
        recognisers_(recognisers) {}

  void fly(const servo::Plan& plan, const RouteTruth& route) {
    std::size_t step = 0;
    for (const LegTruth& leg : route.legs) {
      for (Recogniser& r : recognisers_) r.begin_leg();
      for (std::size_t e = 0; e < leg.edges.size(); ++e) {
        const bool last = e + 1 == leg.edges.size();
        fly_edge(leg.edges[e], e == 0 ? kStart_m : 0.0, last ? kTurnBefore_m : 0.0, plan, step, last);
        ++step;
      }
    }
  }

 private:
  void fly_edge(const TravelledEdge& edge, double from_m, double short_of_m, const servo::Plan& plan,
                std::size_t step, bool last) {
    const double length_m = edge.curve->length_m();
    for (Recogniser& r : recognisers_) ++r.score.events;
    bool expects = false;
    for (double s = from_m; s <= length_m - short_of_m; s += options_.step_m) {
      if (!expects && s > length_m - kSeen_m) {
        expects = true;
        for (Recogniser& r : recognisers_) r.expect(&plan.steps[step].expected);
      }
      see(travelled_point(edge, s));
    }
    if (last) {
      for (Recogniser& r : recognisers_) r.expect(nullptr);
    }
  }

  void see(const vehicle::CurvePoint& point) {
    const Eigen::Isometry3d X_WB = carrier_.at(point);
    Eigen::Isometry3d X_BC = Eigen::Isometry3d::Identity();
    X_BC.linear() = features::down_camera_R_BC();
    renderer_.render(X_WB * X_BC, frame_);
    if (options_.blur_px > 0.0) cv::GaussianBlur(frame_, frame_, {}, options_.blur_px);
    noise_.add(frame_index_++, frame_);
    const CodeTruth truth = truth_.at(X_WB, options_.step_m);
    const double error_rad = radians(options_.attitude_error_deg);
    const features::LevelView view(carrier_.roll_rad + random_.normal(error_rad),
                                   carrier_.pitch_rad + random_.normal(error_rad));
    for (Recogniser& r : recognisers_) r.see(frame_, view, truth, options_.step_m);
  }

  const JunctionStudyOptions& options_;
  features::CameraModel camera_;
  vehicle::FloorRenderer renderer_;
  JunctionTruth truth_;
  vehicle::ImageNoise noise_;
  vehicle::Random random_;
  Carrier carrier_;
  std::vector<Recogniser>& recognisers_;
  cv::Mat frame_;
  std::int64_t frame_index_ = 0;
};

}  // namespace

std::vector<RecogniserScore> study_junctions(const vehicle::Layout& layout,
                                             const JunctionStudyOptions& options) {
  const features::CameraModel camera{features::CameraParameters{}};
  std::vector<Recogniser> recognisers;
  recognisers.emplace_back(camera, features::JunctionMethod::fpd, "fpd");
  recognisers.emplace_back(camera, features::JunctionMethod::stripe, "stripe");
  RouteStudy study(layout, options, recognisers);
  const servo::Topology topology = topology_of(layout);
  for (const std::string& instruction : options.instructions) {
    const servo::Plan plan = servo::compile(topology, servo::find_target(topology, instruction), instruction);
    study.fly(plan, route_truth(layout, plan));
  }
  std::vector<RecogniserScore> scores;
  for (Recogniser& r : recognisers) {
    r.finish();
    scores.push_back(r.score);
  }
  return scores;
}

}  // namespace lineservo::apps
