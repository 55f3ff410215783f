#pragma once

#include <memory>
#include <string>

#include "vehicle/grabber/frame_source.h"

namespace lineservo::vehicle {

/// Passes on the frames of another source as long as they have the size of its format; then throws
/// GrabberError.
class SteadySource : public FrameSource {
 public:
  /// `name`: of the source, for the complaint.
  SteadySource(std::unique_ptr<FrameSource> source, std::string name);

  SourceFormat format() const override { return source_->format(); }
  std::optional<SourceFrame> next() override;

 private:
  std::unique_ptr<FrameSource> source_;
  std::string name_;
};

}  // namespace lineservo::vehicle
