#include "apps/config/camera/camera_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "apps/config/input_error.h"

namespace lineservo::apps {
namespace {

using testing::HasSubstr;

class OwnCamera : public testing::Test {
 protected:
  std::filesystem::path written(const std::string& text) {
    const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
    const std::filesystem::path file =
        std::filesystem::path(testing::TempDir()) / ("own_camera_" + test + ".yaml");
    std::ofstream(file) << text;
    return file;
  }
  std::string complaint(const std::string& text) {
    try {
      read_camera(written(text));
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
};

TEST_F(OwnCamera, OneFocalLengthAndTheMiddleByDefault) {
  const auto camera = read_camera(written("width_px: 320\nheight_px: 200\nfocal_px: 250.5\n"));
  EXPECT_EQ(camera.width_px, 320);
  EXPECT_EQ(camera.height_px, 200);
  EXPECT_EQ(camera.fx_px, 250.5);
  EXPECT_EQ(camera.fy_px, 250.5);
  EXPECT_EQ(camera.cx_px, 159.5);
  EXPECT_EQ(camera.cy_px, 99.5);
  EXPECT_EQ(camera.distortion, (std::array<double, 5>{}));
}

TEST_F(OwnCamera, EverythingGiven) {
  const auto camera =
      read_camera(written("width_px: 320\nheight_px: 200\nfx_px: 250\nfy_px: 260\ncx_px: 150\n"
                          "cy_px: 90\nk1: -0.1\nk2: 0.01\np1: 0.001\np2: 0.002\nk3: 0.003\n"));
  EXPECT_EQ(camera.fx_px, 250.0);
  EXPECT_EQ(camera.fy_px, 260.0);
  EXPECT_EQ(camera.cx_px, 150.0);
  EXPECT_EQ(camera.cy_px, 90.0);
  EXPECT_EQ(camera.distortion, (std::array<double, 5>{-0.1, 0.01, 0.001, 0.002, 0.003}));
}

TEST_F(OwnCamera, SaysWhatIsWrongAndWhere) {
  EXPECT_THAT(complaint("width_px: 320\nheight_px: 200\nfocus: 3\n"), HasSubstr(":3: unknown key 'focus'"));
  EXPECT_THAT(complaint("width_px: 320\nfocal_px: 250\n"), HasSubstr("'height_px' is missing"));
  EXPECT_THAT(complaint("width_px: 320.5\nheight_px: 200\nfocal_px: 250\n"), HasSubstr(":1: key 'width_px'"));
  EXPECT_THAT(complaint("width_px: 320\nheight_px: 200\nfx_px: 250\n"), HasSubstr("either focal_px"));
  EXPECT_THAT(complaint("width_px: 320\nheight_px: 200\nfocal_px: 250\nfx_px: 250\nfy_px: 250\n"),
              HasSubstr("either focal_px"));
  EXPECT_THAT(complaint("width_px: 320\nheight_px: 200\nfocal_px: -1\n"), HasSubstr("fx must be positive"));
}

}  // namespace
}  // namespace lineservo::apps
