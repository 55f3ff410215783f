#include "apps/config/camera/visp_camera.h"

#include "tests/apps/config/camera/camera_files.h"
#include "tests/support/visp_camera.h"

namespace lineservo::apps {
namespace {

using ::testing::HasSubstr;
using testing::with;
using VispCamera = testing::CameraFileTest;

const std::string kFile =
    "<?xml version=\"1.0\"?>\n"
    "<root>\n"
    "  <!-- two models of one camera -->\n"
    "  <camera>\n"
    "    <name>down</name>\n"
    "    <image_width>640</image_width>\n"
    "    <image_height>480</image_height>\n"
    "    <model>\n"
    "      <type>perspectiveProjWithoutDistortion</type>\n"
    "      <px>410</px><py>411</py><u0>321</u0><v0>241</v0>\n"
    "    </model>\n"
    "    <model>\n"
    "      <type>perspectiveProjWithDistortion</type>\n"
    "      <px>401.5</px>\n"
    "      <py>402.5</py>\n"
    "      <u0>320.25</u0>\n"
    "      <v0>240.75</v0>\n"
    "      <kud>-0.061</kud>\n"
    "      <kdu>0.063</kdu>\n"
    "    </model>\n"
    "  </camera>\n"
    "</root>\n";

const support::VispCamera kVisp = {401.5, 402.5, 320.25, 240.75, -0.061, 0.063};

TEST_F(VispCamera, TakesTheModelWithDistortionAndKudAsK1) {
  const auto camera = read(kFile);
  EXPECT_EQ(camera.width_px, 640);
  EXPECT_EQ(camera.height_px, 480);
  EXPECT_EQ(camera.fx_px, 401.5);
  EXPECT_EQ(camera.fy_px, 402.5);
  EXPECT_EQ(camera.cx_px, 320.25);
  EXPECT_EQ(camera.cy_px, 240.75);
  EXPECT_EQ(camera.distortion, (std::array<double, 5>{-0.061, 0.0, 0.0, 0.0, 0.0}));
}

TEST_F(VispCamera, OtherwiseTheOneWithout) {
  const auto camera =
      read(with(kFile, "perspectiveProjWithDistortion", "projectionWithKannalaBrandtDistortion"));
  EXPECT_EQ(camera.fx_px, 410.0);
  EXPECT_EQ(camera.distortion[0], 0.0);
}

TEST_F(VispCamera, TakesWhatVispWrites) {
  const std::string file = temp_.path() / "visp.xml";
  ASSERT_TRUE(support::save_visp_camera(kVisp, file, "down", 640, 480));
  const auto camera = read_camera(file);
  EXPECT_NEAR(camera.fx_px, 401.5, 1e-4);
  EXPECT_NEAR(camera.cy_px, 240.75, 1e-4);
  EXPECT_NEAR(camera.distortion[0], -0.061, 1e-6);
}

TEST_F(VispCamera, ProjectsAsVispDoes) {
  const auto parameters = read(kFile);
  const auto [u, v] = kVisp.pixel(0.3, -0.2);
  const auto pixel = features::CameraModel(parameters).project({0.3, -0.2});
  EXPECT_NEAR(pixel.x, u, 1e-9);
  EXPECT_NEAR(pixel.y, v, 1e-9);
}

TEST_F(VispCamera, SaysWhatIsWrongAndWhere) {
  EXPECT_THAT(refusal(with(kFile, "401.5", "0")), HasSubstr("camera:14: key 'px': must be above 0"));
  EXPECT_THAT(refusal(with(kFile, "<kud>-0.061</kud>", "")), HasSubstr("camera:12: key 'kud' is missing"));
  EXPECT_THAT(refusal(with(kFile, "<image_width>640</image_width>", "")),
              HasSubstr("camera:4: key 'image_width' is missing"));
  EXPECT_THAT(refusal(with(kFile, "<v0>240.75</v0>", "<v0>240.75</v0><v0>1</v0>")),
              HasSubstr("key 'v0' twice"));
  std::string no_model = with(kFile, "perspectiveProjWithDistortion", "other");
  EXPECT_THAT(refusal(with(no_model, "perspectiveProjWithoutDistortion", "other")),
              HasSubstr("camera:4: key 'model': needs one of the type"));
}

TEST_F(VispCamera, RefusesADocumentTypeAndItsEntities) {
  EXPECT_THAT(refusal(with(kFile, "<root>", "<!DOCTYPE root [<!ENTITY a \"401.5\">]>\n<root>")),
              HasSubstr("a document type (<!DOCTYPE) is not allowed"));
}

TEST_F(VispCamera, OfSeveralCamerasTheNamedOne) {
  const std::string camera =
      kFile.substr(kFile.find("  <camera>"), kFile.find("</root>") - kFile.find("  <camera>"));
  const std::string other = with(with(camera, "down", "front"), "401.5", "500");
  const std::string file = temp_.write("two.xml", with(kFile, "</root>", other + "</root>"));
  EXPECT_EQ(read_camera(file + "#front").fx_px, 500.0);
  EXPECT_THAT(testing::complaint([&] { read_camera(file); }), HasSubstr("holds the cameras down, front"));
}

}  // namespace
}  // namespace lineservo::apps
