// Perception alone: the line and the junction code in an image of a camera of 90° that looks straight down.
#include <cstdio>
#include <opencv2/imgcodecs.hpp>

#include "features/perception.h"

using namespace lineservo::features;

int main(int argc, char** argv) {
  const cv::Mat bgr = argc == 2 ? cv::imread(argv[1]) : cv::Mat();
  if (bgr.empty()) return std::fputs("usage: what_line IMAGE\n", stderr), 2;
  const CameraParameters camera = {.width_px = bgr.cols,
                                   .height_px = bgr.rows,
                                   .fx_px = 0.5 * bgr.cols,
                                   .fy_px = 0.5 * bgr.cols,
                                   .cx_px = 0.5 * (bgr.cols - 1),
                                   .cy_px = 0.5 * (bgr.rows - 1)};
  const PerceptionOptions options;
  Perception perception(CameraModel(camera), options);
  const FrameFeatures seen = perception.observe(bgr, FrameContext());
  if (const LineFeature* line = seen.line())
    std::printf("line: rho %.4f, theta %.4f rad; ", line->rho, line->theta_rad);
  std::printf("junction code: %s\n", std::string(name(seen.code.raw)).c_str());
  return seen.line() ? 0 : 1;
}
