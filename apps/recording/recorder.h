#pragma once

#include <opencv2/core/mat.hpp>
#include <span>
#include <string>

#include "apps/onboard/chain_output.h"
#include "apps/output/result_folder.h"
#include "apps/recording/recording_info.h"
#include "apps/recording/recording_table.h"

namespace lineservo::apps {

/// Keeps frames, estimates and commands, each with its hash, so that replay() can check them.
class Recorder {
 public:
  /// Begins frames/ in the folder. `info`: kind, source and controllers. Throws InputError.
  Recorder(ResultFolder& folder, RecordingInfo info);

  /// A tick; `bgr` is none for one without a frame. Throws InputError when the disk is full.
  void add(const TickInput& input, const cv::Mat* bgr, std::span<const ChainOutput> outputs);
  /// Writes recording.json and recording.csv; publishing is the folder's.
  void write();

 private:
  void keep_frame(const cv::Mat& bgr, RecordedTick& tick);

  ResultFolder& folder_;
  RecordingInfo info_;
  std::string table_;
};

/// An earlier recording in the folder goes when it is published without a new one.
void leave_out_recording(ResultFolder& folder);

}  // namespace lineservo::apps
