#include "vehicle/grabber/steady_source.h"

#include <fmt/format.h>

namespace lineservo::vehicle {

SteadySource::SteadySource(std::unique_ptr<FrameSource> source, std::string name)
    : source_(std::move(source)), name_(std::move(name)) {}

std::optional<SourceFrame> SteadySource::next() {
  std::optional<SourceFrame> frame = source_->next();
  const SourceFormat format = source_->format();
  if (frame && (frame->bgr.cols != format.width_px || frame->bgr.rows != format.height_px))
    throw GrabberError(fmt::format("{}: frame {} is {}×{} px, the source {}×{}: the size may not change",
                                   name_, frame->index, frame->bgr.cols, frame->bgr.rows, format.width_px,
                                   format.height_px));
  return frame;
}

}  // namespace lineservo::vehicle
