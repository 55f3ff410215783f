#include "apps/evaluate/junction_report.h"

#include <fmt/format.h>

#include "apps/config/data_folder.h"
#include "apps/config/layout_file.h"
#include "apps/version.h"

namespace lineservo::apps {
namespace {

using nlohmann::ordered_json;

/// How shaky the camera is: yaw and tilt in degrees, blur in pixels; and the share of the paint that is worn
/// off.
struct Trial {
  double yaw_deg, tilt_deg, blur_px, worn_share;
};
constexpr std::array<Trial, 10> kTrials = {{{0, 0, 0, 0},
                                            {0.5, 0, 0, 0},
                                            {1, 0, 0, 0},
                                            {2, 0, 0, 0},
                                            {4, 0, 0, 0},
                                            {4, 2, 0, 0},
                                            {0, 0, 3, 0},
                                            {2, 1, 3, 0},
                                            {0, 0, 0, 0.25},
                                            {2, 1, 0, 0.25}}};
constexpr double kWornGap_m = 0.1;
constexpr double kAttitudeError_deg = 0.2;

/// topology Tab. 2: raw accuracy for a03, a13, a23, a53 and their mean.
constexpr std::array<double, 5> kPublished = {0.9440, 0.9273, 0.9034, 0.9055, 0.9201};

double share_right(long wrong, long frames) {
  return frames == 0 ? 0.0 : 1.0 - static_cast<double>(wrong) / static_cast<double>(frames);
}

ordered_json to_json(const RecogniserScore& s) {
  ordered_json json = {{"method", s.method},
                       {"frames", s.frames},
                       {"accuracy", share_right(s.raw_wrong, s.frames)},
                       {"ambiguous_share", 1.0 - share_right(s.ambiguous, s.frames)},
                       {"events", s.events},
                       {"events_false", s.events_false}};
  for (std::size_t w = 0; w < kWindows.size(); ++w) {
    const std::string window = std::to_string(kWindows[w]);
    json["smoothed_accuracy"][window] = share_right(s.smoothed_wrong[w], s.frames);
    json["events_right"][window] = s.events_right[w];
  }
  json["confusion"] = s.confusion;
  json["perception_ms"] = s.perception_ms;
  return json;
}

std::string table_row(const JunctionCase& c, const RecogniserScore& s) {
  const JunctionStudyOptions& o = c.options;
  std::string row = fmt::format("{:<15} {:>4} {:>4} {:>4} {:>4}  {:<7} {:7.2f}", c.layout, o.yaw_sigma_deg,
                                o.tilt_sigma_deg, o.blur_px, o.wear.worn_share, s.method,
                                100.0 * share_right(s.raw_wrong, s.frames));
  for (const long wrong : s.smoothed_wrong)
    row += fmt::format(" {:6.2f}", 100.0 * share_right(wrong, s.frames));
  return row + fmt::format("   {:>2} of {} ({} false)  {:5.2f}  {:.3f}\n", s.events_right[2], s.events,
                           s.events_false, 100.0 * (1.0 - share_right(s.ambiguous, s.frames)),
                           s.perception_ms);
}

}  // namespace

std::vector<JunctionCase> junction_cases(std::uint64_t seed) {
  std::vector<JunctionCase> cases;
  for (const char* layout : {"warehouse", "tape-warehouse"}) {
    for (const Trial& trial : kTrials) {
      JunctionCase c{layout, {}, {}};
      c.options.yaw_sigma_deg = trial.yaw_deg;
      c.options.tilt_sigma_deg = trial.tilt_deg;
      c.options.blur_px = trial.blur_px;
      c.options.wear.worn_share = trial.worn_share;
      c.options.wear.gap_m = trial.worn_share > 0.0 ? kWornGap_m : 0.0;
      c.options.attitude_error_deg = trial.tilt_deg > 0.0 ? kAttitudeError_deg : 0.0;
      c.options.seed = seed;
      cases.push_back(c);
    }
  }
  return cases;
}

void run(std::vector<JunctionCase>& cases, const std::function<void(std::size_t, std::size_t)>& progress) {
  for (std::size_t i = 0; i < cases.size(); ++i) {
    progress(i, cases.size());
    const vehicle::Layout layout = read_layout(find_data(DataKind::layout, cases[i].layout));
    cases[i].scores = study_junctions(layout, cases[i].options);
  }
}

std::string junction_table(const std::vector<JunctionCase>& cases) {
  std::string text =
      "Frames along a03, a13, a23, a53; yaw and tilt jitter (standard deviation, degrees), blur (px), share "
      "of worn paint. Raw accuracy and\n"
      "smoothed by window in % of the frames; nodes told with the right code at window 5; ambiguous frames "
      "in %; ms a frame.\n"
      "layout           yaw tilt blur worn  method      raw    w=1    w=3    w=5    w=9   nodes            "
      "ambig  "
      "ms\n";
  for (const JunctionCase& c : cases) {
    for (const RecogniserScore& s : c.scores) text += table_row(c, s);
  }
  return text + fmt::format(
                    "published (topology Tab. 2, raw): a03 {:.2f}, a13 {:.2f}, a23 {:.2f}, a53 {:.2f}, mean "
                    "{:.2f}\n",
                    100 * kPublished[0], 100 * kPublished[1], 100 * kPublished[2], 100 * kPublished[3],
                    100 * kPublished[4]);
}

ordered_json junction_json(const std::vector<JunctionCase>& cases) {
  ordered_json json = {{"kind", "junctions"}, {"version", kVersion}, {"published_accuracy", kPublished}};
  for (const JunctionCase& c : cases) {
    ordered_json one = {{"layout", c.layout},
                        {"yaw_sigma_deg", c.options.yaw_sigma_deg},
                        {"tilt_sigma_deg", c.options.tilt_sigma_deg},
                        {"blur_px", c.options.blur_px},
                        {"worn_share", c.options.wear.worn_share},
                        {"seed", c.options.seed}};
    for (const RecogniserScore& s : c.scores) one["recognisers"].push_back(to_json(s));
    json["cases"].push_back(one);
  }
  return json;
}

std::string junction_csv(const std::vector<JunctionCase>& cases) {
  std::string csv =
      "layout,yaw_sigma_deg,tilt_sigma_deg,blur_px,worn_share,method,frames,accuracy,smoothed_1,smoothed_3,"
      "smoothed_5,"
      "smoothed_9,"
      "events,events_right,events_false,ambiguous_share\n";
  for (const JunctionCase& c : cases) {
    for (const RecogniserScore& s : c.scores) {
      csv += fmt::format("{},{},{},{},{},{},{},{}", c.layout, c.options.yaw_sigma_deg,
                         c.options.tilt_sigma_deg, c.options.blur_px, c.options.wear.worn_share, s.method,
                         s.frames, share_right(s.raw_wrong, s.frames));
      for (const long wrong : s.smoothed_wrong) csv += fmt::format(",{}", share_right(wrong, s.frames));
      csv += fmt::format(",{},{},{},{}\n", s.events, s.events_right[2], s.events_false,
                         1.0 - share_right(s.ambiguous, s.frames));
    }
  }
  return csv;
}

}  // namespace lineservo::apps
