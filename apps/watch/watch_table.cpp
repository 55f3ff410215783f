#include "apps/watch/watch_table.h"

#include <fmt/format.h>

#include <limits>

#include "apps/output/command_columns.h"

namespace lineservo::apps {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::string feature_cells(const features::FrameFeatures& f) {
  const features::LineFeature* line = f.line();
  const features::LevelPoint junction = f.junction ? f.junction->centre : features::LevelPoint{kNaN, kNaN};
  return fmt::format("{},{:.6f},{:.6f},{:.4f},{:.6f},{:.6f},{},{},{}", line ? 1 : 0, line ? line->rho : kNaN,
                     line ? line->theta_rad : kNaN, line ? line->quality : kNaN, junction.x, junction.y,
                     static_cast<int>(f.code.raw), static_cast<int>(f.code.held),
                     static_cast<int>(f.code.smoothed));
}

}  // namespace

std::string watch_header(const std::vector<std::string>& controllers) {
  std::string header =
      "t_s,frame,found,line_rho,line_theta_rad,quality,junction_x,junction_y,code_raw,code_held,"
      "code_smoothed,height_m,perception_ms,delay_ms";
  for (const std::string& controller : controllers) header += command_columns(controller);
  return header + "\n";
}

std::string watch_row(const Watched& watched) {
  const WatchTick& tick = watched.tick;
  const std::string frame = tick.bgr.empty() ? "" : fmt::format("{}", tick.frame);
  std::string row = fmt::format("{:.4f},{},{},{:.6f},{:.4f},{:.3f}", servo::seconds(tick.input.now), frame,
                                feature_cells(watched.outputs.front().features), tick.input.estimate.height_m,
                                watched.perception_ms, watched.delay_ms.value_or(kNaN));
  for (const ChainOutput& output : watched.outputs) row += command_cells(row_of(output.command));
  return row + "\n";
}

}  // namespace lineservo::apps
