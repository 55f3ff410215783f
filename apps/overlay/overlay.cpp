#include "apps/overlay/overlay.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "apps/overlay/command_overlay.h"
#include "apps/overlay/feature_overlay.h"
#include "apps/overlay/ink.h"
#include "apps/overlay/junction_sign.h"
#include "features/geometry/angles.h"

namespace lineservo::apps {
namespace {

constexpr int kLeastWidth_px = 640, kMostHeight_px = 1080;  // of an enlarged frame
constexpr double kUsualHeight_px = 480.0;                   // for which the sizes below are meant

// The panel, at scale 1.
constexpr double kPanelWidth = 214.0, kMargin = 12.0;
constexpr double kTitleFoot = 22.0, kMapTop = 32.0, kMapHeight = 178.0;
constexpr double kLaw = 22.0, kPhase = 40.0, kCodes = 50.0, kCommand = 156.0, kRow = 18.0;  // below the map
constexpr double kTitleHeight = 13.0, kTextHeight = 11.0, kNoteHeight = 9.0;

const Stroke kLabel{ink::kLabel, 1.0}, kValue{ink::kText, 1.0};

int even(double side_px) {
  return 2 * static_cast<int>(std::ceil(0.5 * side_px));
}

int zoom_of(const features::CameraParameters& camera) {
  const int wanted = (kLeastWidth_px + camera.width_px - 1) / camera.width_px;
  return std::max(1, std::min(wanted, kMostHeight_px / camera.height_px));
}

struct Row {
  std::string label, value;
};

/// Without a minus sign before what is shown as zero.
std::string number(double value, const char* unit) {
  const double shown = std::abs(value) < 0.005 ? 0.0 : value;
  return fmt::format("{:.2f} {}", shown, unit);
}

std::string angle(double angle_rad, const char* unit) {
  const double angle_deg = features::degrees(angle_rad);
  return fmt::format("{:.1f} {}", std::abs(angle_deg) < 0.05 ? 0.0 : angle_deg, unit);
}

/// As much of a text as fits.
std::string cut(std::string text, const Canvas& canvas, double height_px, double most_px) {
  if (canvas.width_of(text, height_px) <= most_px) return text;
  while (!text.empty() && canvas.width_of(text + "..", height_px) > most_px) text.pop_back();
  return text + "..";
}

std::vector<Row> rows_of(const servo::Command& command) {
  if (const auto* v = std::get_if<servo::VelocityCommand>(&command))
    return {{"forward", number(v->forward_m_s, "m/s")},
            {"left", number(v->left_m_s, "m/s")},
            {"up", number(v->up_m_s, "m/s")},
            {"yaw", angle(v->yaw_rate_rad_s, "deg/s")}};
  if (const auto* a = std::get_if<servo::AttitudeCommand>(&command))
    return {{"pitch", angle(a->pitch_rad, "deg")},
            {"roll", angle(a->roll_rad, "deg")},
            {"height", number(a->height_m, "m")},
            {"yaw", angle(a->yaw_rate_rad_s, "deg/s")}};
  return {{"command", "land"}};
}

void draw_row(Canvas& panel, double foot, const Row& row) {
  const double s = panel.scale();
  panel.text({kMargin * s, foot * s}, row.label, kTextHeight, kLabel);
  const double right = panel.size().width - kMargin * s;
  panel.text({right - panel.width_of(row.value, kTextHeight), foot * s}, row.value, kTextHeight, kValue);
}

}  // namespace

Overlay::Overlay(const features::CameraParameters& camera, OverlayOptions options)
    : camera_(camera), options_(std::move(options)), zoom_(zoom_of(camera)) {
  frame_place_ = {0, 0, camera.width_px * zoom_, camera.height_px * zoom_};
  scale_ = std::max(1.0, frame_place_.height / kUsualHeight_px);
  picture_.create(even(std::max<double>(frame_place_.height, kUsualHeight_px * scale_)),
                  even(frame_place_.width + kPanelWidth * scale_), CV_8UC3);
  picture_.setTo(ink::kPanel);
  panel_place_ = {frame_place_.width, 0, picture_.cols - frame_place_.width, picture_.rows};
}

Overlay::Overlay(const features::CameraParameters& camera, OverlayOptions options,
                 const vehicle::Layout& floor, const servo::Plan& plan)
    : Overlay(camera, std::move(options)) {
  const double width = panel_place_.width - 2.0 * kMargin * scale_;
  map_.emplace(floor, plan, cv::Size(static_cast<int>(width), static_cast<int>(kMapHeight * scale_)), scale_);
}

cv::Rect Overlay::map_place() const {
  if (!map_) return {};
  const cv::Size size = map_->size();
  return {panel_place_.x + (panel_place_.width - size.width) / 2, static_cast<int>(scale_ * kMapTop),
          size.width, size.height};
}

const cv::Mat& Overlay::draw(const OverlayScene& scene) {
  draw_camera(scene);
  draw_panel(scene);
  if (map_ && scene.vehicle) map_->draw(picture_(map_place()), *scene.vehicle);
  return picture_;
}

void Overlay::draw_camera(const OverlayScene& scene) {
  cv::Mat frame = picture_(frame_place_);
  if (scene.bgr) {
    cv::resize(*scene.bgr, frame, frame_place_.size(), 0.0, 0.0, cv::INTER_LINEAR);
    frame.copyTo(last_frame_);
  } else if (!last_frame_.empty()) {
    last_frame_.convertTo(frame, -1, 0.4);
  } else {
    frame.setTo(ink::kPanel);
  }
  Canvas canvas(frame, scale_);
  if (scene.bgr) draw_features(canvas, camera_, scene, zoom_);
  draw_command(canvas, frame_place_, scene.command, options_.speed_m_s);
  if (!scene.bgr)
    canvas.text({kMargin * scale_, 24.0 * scale_}, "no frame", 14.0, {ink::kWhite, 2.0, 1.5, ink::kBlack});
}

void Overlay::draw_panel(const OverlayScene& scene) {
  picture_(panel_place_).setTo(ink::kPanel);
  Canvas panel = Canvas(picture_, scale_).part(panel_place_);
  const std::string time = fmt::format("{:.1f} s", scene.time_s);
  const double right = panel.size().width - kMargin * scale_;
  const double time_left = right - panel.width_of(time, kTitleHeight);
  const std::string title = cut(options_.title, panel, kTitleHeight, time_left - 2.0 * kMargin * scale_);
  panel.text({kMargin * scale_, kTitleFoot * scale_}, title, kTitleHeight, kValue);
  panel.text({time_left, kTitleFoot * scale_}, time, kTitleHeight, kValue);
  const double below = kMapTop + (map_ ? map_->size().height / scale_ : 0.0);
  if (!options_.law.empty()) draw_row(panel, below + kLaw, {"law", options_.law});
  if (!scene.phase.empty()) draw_row(panel, below + kPhase, {"phase", scene.phase});
  draw_codes(panel, scene, below + kCodes);
  double foot = below + kCommand;
  for (const Row& row : rows_of(scene.command)) {
    draw_row(panel, foot, row);
    foot += kRow;
  }
  draw_row(panel, foot, {"at height", number(scene.height_m, "m")});
  draw_notes(panel);
}

// What is seen on the left, what is expected on the right.
void Overlay::draw_codes(Canvas& panel, const OverlayScene& scene, double top) const {
  const double s = scale_, half = 0.5 * panel.size().width;
  const auto box = [&](double left, const std::string& label, const std::string& name) {
    panel.rectangle({left + kMargin * s, top * s, half - 1.5 * kMargin * s, 84.0 * s}, {60, 54, 50});
    panel.text({left + (kMargin + 7.0) * s, (top + 16.0) * s}, label, kNoteHeight, kLabel);
    const bool is_short = panel.width_of(name, kTextHeight) < half - (1.5 * kMargin + 14.0) * s;
    panel.text({left + (kMargin + 7.0) * s, (top + 77.0) * s}, name, is_short ? kTextHeight : kNoteHeight,
               kValue);
    return cv::Point2d(left + kMargin * s + 0.5 * (half - 1.5 * kMargin * s), (top + 41.0) * s);
  };
  const features::JunctionCode seen = scene.features.code.smoothed;
  draw_sign(panel, box(0.0, "seen", std::string(features::name(seen))), 17.0, seen);
  if (!scene.next) return;
  draw_sign(panel, box(half - 0.5 * kMargin * s, "expected", short_name(*scene.next)), 17.0, *scene.next);
}

void Overlay::draw_notes(Canvas& panel) const {
  double foot =
      panel.size().height / scale_ - 10.0 - 13.0 * (static_cast<double>(options_.notes.size()) - 1.0);
  for (const std::string& note : options_.notes) {
    panel.text({kMargin * scale_, foot * scale_}, note, kNoteHeight, kLabel);
    foot += 13.0;
  }
}

}  // namespace lineservo::apps
