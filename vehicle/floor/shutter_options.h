#pragma once

namespace lineservo::vehicle {

/// How long a frame takes.
struct ShutterOptions {
  static constexpr int kMostSamples = 32;

  double exposure_s = 0.0;  ///< of each row, 0 … 0.1; 0: in no time
  double readout_s = 0.0;   ///< from the first row's exposure to the last one's, 0 … 0.1; 0: all at once
  int samples = 5;          ///< instants that stand for the exposure, 1 … 32

  bool is_instant() const { return exposure_s == 0.0 && readout_s == 0.0; }
  /// From the first row's opening to the last row's closing, half of it.
  double half_window_s() const { return 0.5 * (exposure_s + readout_s); }
  /// Throws std::invalid_argument that names what is out of bounds.
  void validate() const;
};

}  // namespace lineservo::vehicle
