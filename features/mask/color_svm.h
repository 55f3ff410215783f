#pragma once

#include <opencv2/core/types.hpp>
#include <opencv2/ml.hpp>
#include <string>
#include <vector>

namespace lineservo::features {

/// A colour with what it is.
struct ColorSample {
  cv::Vec3b bgr;
  bool is_paint = false;
};

/// Paint or not, by a support vector machine on HSV (grid §IV-A): a Gaussian kernel on the point of the HSV
/// cone, (S cos H, S sin H, V) with S and V in 0…1, in which hue does not wrap and pale colours lie together.
class ColorSvm {
 public:
  /// The same samples give the same machine. Throws std::invalid_argument unless there are both kinds.
  static ColorSvm trained(const std::vector<ColorSample>& samples);
  /// From to_text(). Throws std::invalid_argument for any other text.
  static ColorSvm from_text(const std::string& text);

  std::string to_text() const;

  /// Distance from the separating surface, in margins; positive for paint.
  double decision(cv::Vec3b bgr) const;
  /// The same for many colours at once.
  std::vector<double> decisions(const std::vector<cv::Vec3b>& colors) const;

 private:
  explicit ColorSvm(cv::Ptr<cv::ml::SVM> machine);

  cv::Ptr<cv::ml::SVM> machine_;
  double sign_ = 1.0;  ///< of the machine's raw output for paint
};

}  // namespace lineservo::features
