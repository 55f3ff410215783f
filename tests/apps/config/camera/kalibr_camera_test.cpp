#include "apps/config/camera/kalibr_camera.h"

#include "tests/apps/config/camera/camera_files.h"

namespace lineservo::apps {
namespace {

using ::testing::HasSubstr;
using testing::with;
using KalibrCamera = testing::CameraFileTest;

const std::string kFile =
    "cam0:\n"
    "  cam_overlaps: []\n"
    "  camera_model: pinhole\n"
    "  distortion_coeffs: [-0.28, 0.07, 0.0002, 0.00002]\n"
    "  distortion_model: radtan\n"
    "  intrinsics: [458.6, 457.3, 367.2, 248.4]\n"
    "  resolution: [752, 480]\n"
    "  rostopic: /cam0/image_raw\n"
    "  T_cam_imu:\n"
    "  - [0.0, 1.0, 0.0, 0.1]\n"
    "  - [1.0, 0.0, 0.0, 0.2]\n"
    "  - [0.0, 0.0, -1.0, 0.3]\n"
    "  - [0.0, 0.0, 0.0, 1.0]\n";

std::string second_camera() {
  return with(with(kFile, "cam0", "cam1"), "458.6", "460.5");
}

TEST_F(KalibrCamera, TakesTheOnlyCamera) {
  const auto camera = read(kFile);
  EXPECT_EQ(camera.width_px, 752);
  EXPECT_EQ(camera.height_px, 480);
  EXPECT_EQ(camera.fx_px, 458.6);
  EXPECT_EQ(camera.fy_px, 457.3);
  EXPECT_EQ(camera.cx_px, 367.2);
  EXPECT_EQ(camera.cy_px, 248.4);
  EXPECT_EQ(camera.distortion, (std::array<double, 5>{-0.28, 0.07, 0.0002, 0.00002, 0.0}));
}

TEST_F(KalibrCamera, TakesTheNamedOneOfSeveral) {
  EXPECT_THAT(refusal(kFile + second_camera()), HasSubstr("holds the cameras cam0, cam1: choose one as "));
  const std::string file = temp_.path() / "camera";
  EXPECT_EQ(read_camera(file + "#cam1").fx_px, 460.5);
  EXPECT_THAT(testing::complaint([&] { read_camera(file + "#cam2"); }),
              HasSubstr("has no camera 'cam2'; it holds cam0, cam1"));
}

TEST_F(KalibrCamera, WithoutALensItIsAPinhole) {
  const auto camera = read(with(with(kFile, "radtan", "none"), "-0.28, 0.07, 0.0002, 0.00002", ""));
  EXPECT_EQ(camera.distortion, (std::array<double, 5>{}));
}

TEST_F(KalibrCamera, RefusesLensesThatCannotBeHeld) {
  EXPECT_THAT(refusal(with(kFile, "radtan", "equidistant")),
              HasSubstr("camera:5: key 'distortion_model': the lens model 'equidistant' is refused"));
  EXPECT_THAT(refusal(with(kFile, "pinhole", "omni")),
              HasSubstr("camera:3: key 'camera_model': the lens model 'omni' is refused"));
}

TEST_F(KalibrCamera, SaysWhatIsWrongAndWhere) {
  EXPECT_THAT(refusal(with(kFile, "458.6, ", "")),
              HasSubstr("camera:6: key 'intrinsics': must be fx, fy, cx, cy"));
  EXPECT_THAT(refusal(with(kFile, "[752, 480]", "[752]")),
              HasSubstr("camera:7: key 'resolution': must be 2 numbers of pixels"));
  EXPECT_THAT(refusal(with(kFile, "  resolution: [752, 480]\n", "")),
              HasSubstr("camera:2: key 'resolution' is missing"));
  EXPECT_THAT(refusal(with(kFile, "-0.28, ", "")),
              HasSubstr("camera:4: key 'distortion_coeffs': has 3 numbers"));
}

}  // namespace
}  // namespace lineservo::apps
