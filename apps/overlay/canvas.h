#pragma once

#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

namespace lineservo::apps {

/// How a line is drawn: with a rim in another colour it stands out from any ground.
struct Stroke {
  cv::Scalar colour;
  double width_px = 1.0;
  double rim_px = 0.0;
  cv::Scalar rim = {0, 0, 0};
};

/// Draws on a picture (CV_8UC3, BGR) to a fraction of a pixel. (0, 0) is the middle of the top left pixel.
/// `scale` multiplies every width, size and font, not positions.
class Canvas {
 public:
  Canvas(cv::Mat picture, double scale) : picture_(std::move(picture)), scale_(scale) {}

  cv::Size size() const { return picture_.size(); }
  double scale() const { return scale_; }
  /// The same scale on a part of the picture, with its own origin.
  Canvas part(const cv::Rect& rect) const { return {picture_(rect), scale_}; }

  void polyline(const std::vector<cv::Point2d>& points, const Stroke& stroke);
  void line(cv::Point2d from, cv::Point2d to, const Stroke& stroke) { polyline({from, to}, stroke); }
  /// With its head at `to`.
  void arrow(cv::Point2d from, cv::Point2d to, const Stroke& stroke, double head_px = 9.0);
  void circle(cv::Point2d centre, double radius_px, const Stroke& stroke);
  void disc(cv::Point2d centre, double radius_px, const cv::Scalar& colour);
  void polygon(const std::vector<cv::Point2d>& corners, const cv::Scalar& colour);
  void rectangle(const cv::Rect2d& rect, const cv::Scalar& colour);
  /// `left_foot`: where the text's base line begins. ASCII; letters are about `height_px` high.
  void text(cv::Point2d left_foot, const std::string& text, double height_px, const Stroke& stroke);
  /// How wide a text is, in pixels of the picture.
  double width_of(const std::string& text, double height_px) const;

 private:
  cv::Mat picture_;
  double scale_;
};

}  // namespace lineservo::apps
