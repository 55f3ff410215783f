#include "apps/flight/flight.h"

#include <time.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "apps/flight/convert.h"
#include "features/geometry/angles.h"
#include "vehicle/attitude.h"
#include "vehicle/random.h"

namespace lineservo::apps {
namespace {

using Clock = std::chrono::steady_clock;
using features::radians;
using servo::Phase;
using vehicle::Time;

// Streams of the flight's seed; the vehicle takes those below 1000 for its sensors.
constexpr std::uint64_t kStartStream = 1000;
constexpr std::uint64_t kLatencyStream = 1001;

constexpr Time kEstimatePeriod = std::chrono::milliseconds(5);
constexpr Time kCommandHolds = std::chrono::milliseconds(300);

/// Processor time of this thread: what other threads and programs do does not count.
double thread_cpu_s() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// Adds the processor time of its life to a stage.
class Stopwatch {
 public:
  explicit Stopwatch(StageTiming& stage) : stage_(stage) {}
  ~Stopwatch() {
    stage_.total_s += thread_cpu_s() - begin_s_;
    ++stage_.calls;
  }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  StageTiming& stage_;
  double begin_s_ = thread_cpu_s();
};

vehicle::StartPlace draw_start(const FlightRequest& request, const vehicle::Layout& floor,
                               double heading_rad) {
  vehicle::Random random(request.seed, kStartStream);
  const StartSettings& spread = request.settings.start;
  const Eigen::Vector2d node = floor.nodes[floor.start].p_W;
  const double x = node.x() + random.uniform(-spread.position_spread_m, spread.position_spread_m);
  const double y = node.y() + random.uniform(-spread.position_spread_m, spread.position_spread_m);
  const double off_deg = random.uniform(-spread.heading_spread_deg, spread.heading_spread_deg);
  return {x, y, heading_rad + radians(off_deg)};
}

Time draw_known_latency(const FlightRequest& request) {
  vehicle::Random random(request.seed, kLatencyStream);
  const CameraSettings& camera = request.settings.camera;
  return vehicle::from_seconds(
      std::max(0.0, camera.latency_s + random.uniform(-camera.latency_error_s, camera.latency_error_s)));
}

Eigen::Isometry3d pose_of(const vehicle::BodyState& state) {
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  X_WB.linear() = state.q_WB.toRotationMatrix();
  X_WB.translation() = state.p_WB;
  return X_WB;
}

TruthSample sample(const vehicle::Quadrotor& quadrotor, const servo::Executive& executive) {
  const vehicle::BodyState& truth = quadrotor.truth();
  const vehicle::RollPitchYaw angles = vehicle::roll_pitch_yaw(truth.q_WB);
  return {quadrotor.now(),  truth.p_WB,        angles.roll_rad,
          angles.pitch_rad, angles.yaw_rad,    truth.v_W,
          truth.w_B,        executive.phase(), static_cast<int>(executive.step())};
}

std::unique_ptr<vehicle::Wind> make_wind(const FlightRequest& request) {
  return std::make_unique<vehicle::Weather>(weather_parameters(request.settings.wind, request.seed),
                                            request.seed);
}

vehicle::StartPlace start_facing(const FlightRequest& request, const vehicle::Layout& floor,
                                 const servo::Plan& plan) {
  return draw_start(request, floor, plan.start_heading_rad);
}

/// Later than by its latency, however it varies, and the reading out, no frame should come.
Time oldest_frame(const CameraSettings& camera) {
  constexpr double kAllowance_s = 0.05;
  const double latest_s = camera.latency_s + camera.latency_jitter_s;
  const double read_out_s = camera.shutter.exposure_s + camera.shutter.readout_s;
  return vehicle::from_seconds(std::max(latest_s, read_out_s) + kAllowance_s);
}

/// What is lost on the way now and then is no reason to go on without.
Time patience(const CameraSettings& camera) {
  return vehicle::from_seconds(std::max(0.25, 2.5 / camera.frame_rate_hz));
}

/// That of the settings for each target, and what the mission itself waits there.
double time_limit_s(const FlightRequest& request, const servo::Plan& plan) {
  double limit_s = 0.0;
  for (const std::size_t index : target_steps(plan)) {
    const servo::Stop& stop = plan.steps[index].stop;
    limit_s += request.settings.time_limit_s + stop.hover_s.value_or(0.0) + stop.ground_s;
  }
  return limit_s;
}

std::string_view name(vehicle::AutopilotMode mode) {
  switch (mode) {
    case vehicle::AutopilotMode::idle:
      return "idle";
    case vehicle::AutopilotMode::tracking:
      return "follows commands again";
    case vehicle::AutopilotMode::braking:
      return "brakes: commands ran out, or no paint was in sight on too long a way";
    case vehicle::AutopilotMode::landing:
      return "lands";
    case vehicle::AutopilotMode::landed:
      return "has landed";
  }
  return "?";
}

}  // namespace

Flight::Flight(const FlightRequest& request, const vehicle::Layout& floor, const servo::Plan& plan)
    : request_(request),
      quadrotor_(airframe_parameters(request.settings), request.settings.autopilot,
                 sensor_parameters(request.settings.sensors), make_wind(request), request.seed,
                 start_facing(request, floor, plan), request.settings.faults.sensors),
      camera_(floor, camera_options(request.settings, request.seed), request.seed),
      frame_faults_(request.settings.faults.frames),
      gate_(oldest_frame(request.settings.camera), patience(request.settings.camera)),
      chain_(request, plan),
      latency_known_(draw_known_latency(request)),
      time_limit_s_(time_limit_s(request, plan)) {}

FlightRecord Flight::run(const std::function<bool(const FlightProgress&)>& progress) {
  const Clock::time_point begin = Clock::now();
  Time next_report{0};
  while (step()) {
    if (progress && quadrotor_.now() >= next_report) {
      next_report += std::chrono::seconds(1);
      record_.interrupted = !progress({vehicle::seconds(quadrotor_.now()), chain_.executive().phase(),
                                       static_cast<int>(chain_.executive().step()),
                                       static_cast<int>(chain_.executive().plan().steps.size())});
    }
  }
  finish();
  record_.timing.wall_s = std::chrono::duration<double>(Clock::now() - begin).count();
  return std::move(record_);
}

bool Flight::step() {
  if (is_over()) return false;
  advance();
  expose();
  control();
  return true;
}

void Flight::advance() {
  const Stopwatch watch(record_.timing.physics);
  const Time until =
      std::min({quadrotor_.now() + kEstimatePeriod, camera_.next_exposure(), camera_.next_delivery()});
  do {
    quadrotor_.step();
    if (camera_.follows_motion()) camera_.move(quadrotor_.now(), pose_of(quadrotor_.truth()));
    sample_truth();
  } while (quadrotor_.now() < until);
  const vehicle::Estimate& estimate = quadrotor_.estimate();
  odometry_.add(estimate.stamp, estimate.v_H_m_s.head<2>(), estimate.yaw_rad);
}

void Flight::sample_truth() {
  if (quadrotor_.now() % kTruthPeriod == Time{0})
    record_.truth.push_back(sample(quadrotor_, chain_.executive()));
}

void Flight::expose() {
  if (camera_.due(quadrotor_.now())) {
    camera_.capture(quadrotor_.now(), pose_of(quadrotor_.truth()));
    exposures_.push_back(sample(quadrotor_, chain_.executive()));
  }
  while (camera_.has_exposed(quadrotor_.now())) {
    const Stopwatch watch(record_.timing.render);
    camera_.develop();
  }
}

// Frames that are fit to be looked at; without any for too long, the flight goes on blind.
void Flight::control() {
  const Time now = quadrotor_.now();
  while (auto frame = camera_.deliver(now)) frame_faults_.take(std::move(*frame), now);
  while (const auto frame = frame_faults_.deliver(now)) {
    if (gate_.accepts(*frame, now, in_flight())) tick(&*frame);
  }
  if (gate_.is_blind(now)) tick(nullptr);
  if (auto news = gate_.take_news()) report("camera", std::move(*news));
  watch_autopilot();
}

// Off the ground nothing stands still.
bool Flight::in_flight() const {
  constexpr double kOffGround_m = 0.1;
  return quadrotor_.estimate().height_m > request_.settings.airframe.gear_height_m + kOffGround_m;
}

// observe → extract → decide and compute → send → log
void Flight::tick(const vehicle::Frame* frame) {
  const TickInput input = observe(frame);
  features::FrameFeatures features;
  if (frame) {
    const Stopwatch watch(record_.timing.perception);
    features = chain_.see(input, frame->bgr);
  }
  servo::Command command;
  {
    const Stopwatch watch(record_.timing.control);
    command = chain_.command(input, std::move(features));
  }
  send(command);
  log(input, command);
  if (on_tick_)
    on_tick_({input, frame ? &frame->bgr : nullptr, chain_.observation().features, command, chain_,
              record_.ticks.back().now});
}

void Flight::watch_autopilot() {
  const vehicle::AutopilotMode before = std::exchange(mode_, quadrotor_.mode());
  const bool is_news = mode_ != before && before != vehicle::AutopilotMode::idle;
  if (is_news) report("autopilot", std::string(name(mode_)));
}

void Flight::report(std::string kind, std::string detail) {
  record_.events.push_back({quadrotor_.now(), std::move(kind), std::move(detail)});
}

TickInput Flight::observe(const vehicle::Frame* frame) const {
  TickInput input;
  input.now = quadrotor_.now();
  input.captured = std::max(Time{0}, quadrotor_.now() - latency_known_);
  input.has_frame = frame != nullptr;
  if (frame) input.exposed = frame->stamp;
  const vehicle::Estimate at_capture = quadrotor_.estimate_at(input.captured);
  input.roll_rad = at_capture.roll_rad;
  input.pitch_rad = at_capture.pitch_rad;
  const vehicle::Estimate& now = quadrotor_.estimate();
  input.estimate = {.odometry_now = odometry_.at(input.now),
                    .odometry_at_capture = odometry_.at(input.captured),
                    .height_m = std::max(kLowestHeight_m, now.height_m),
                    .capture_height_m = std::max(kLowestHeight_m, at_capture.height_m),
                    .v_H_m_s = now.v_H_m_s,
                    .height_age_s = vehicle::seconds(input.now - now.range_heard),
                    .velocity_age_s = vehicle::seconds(input.now - now.flow_heard)};
  input.on_ground = !vehicle::motors_run(quadrotor_.mode());
  return input;
}

void Flight::send(const servo::Command& command) {
  quadrotor_.command(to_setpoint(command), quadrotor_.now(), kCommandHolds);
}

void Flight::log(const TickInput& input, const servo::Command& command) {
  const servo::Observation& observation = chain_.observation();
  if (!observation.features.lines.empty()) quadrotor_.paint_sighted(observation.captured);
  TickRecord tick;
  tick.t = observation.now;
  tick.has_frame = input.has_frame;
  tick.captured = input.has_frame ? input.exposed : observation.captured;
  while (exposures_.size() > 1 && exposures_.front().t < tick.captured) exposures_.pop_front();
  tick.at_capture = exposures_.front();
  tick.now = sample(quadrotor_, chain_.executive());
  tick.code = observation.features.code;
  if (const features::LineFeature* line = observation.features.line()) {
    tick.line_rho = line->rho;
    tick.line_theta_rad = line->theta_rad;
  }
  if (observation.features.junction) tick.junction = observation.features.junction->centre;
  tick.height_m = observation.estimate.height_m;
  tick.v_H_m_s = observation.estimate.v_H_m_s;
  tick.odometry = input.estimate.odometry_now;
  tick.command = command;
  record_.ticks.push_back(tick);
  for (servo::ExecutiveEvent& event : chain_.take_events()) {
    report(std::move(event.kind), std::move(event.detail));
  }
}

bool Flight::is_over() const {
  const bool on_ground = !vehicle::motors_run(quadrotor_.mode());
  const bool gave_up =
      chain_.executive().phase() == Phase::land && on_ground && chain_.executive().ends_on_ground();
  return chain_.executive().phase() == Phase::finished || gave_up || quadrotor_.crashed() ||
         record_.interrupted || is_out_of_time();
}

bool Flight::is_out_of_time() const {
  return vehicle::seconds(quadrotor_.now()) >= time_limit_s_;
}

void Flight::finish() {
  record_.abort_reason = chain_.executive().abort_reason();
  record_.last_phase = chain_.executive().phase();
  record_.steps_done = chain_.executive().nodes_recognised();
  record_.crashed = quadrotor_.crashed();
  record_.landed = quadrotor_.mode() == vehicle::AutopilotMode::landed;
  record_.out_of_time = is_out_of_time();
}

}  // namespace lineservo::apps
