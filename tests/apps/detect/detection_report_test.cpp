#include "apps/detect/detection_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "features/geometry/angles.h"

namespace lineservo::apps {
namespace {

using testing::HasSubstr;

std::vector<std::string> keys_of(const nlohmann::ordered_json& json) {
  std::vector<std::string> keys;
  for (const auto& item : json.items()) keys.push_back(item.key());
  return keys;
}

DetectionReport a_cross() {
  DetectionReport report{.image = "a.png",
                         .method = "stripe",
                         .width_px = 640,
                         .height_px = 480,
                         .detection = {},
                         .perception_ms = 12.5,
                         .error = {}};
  report.detection.lines = {features::line_through({320.0, 479.0}, {320.0, 0.0}),
                            features::line_through({639.0, 240.0}, {0.0, 240.0})};
  report.detection.color = features::LineColor::black;
  report.detection.code = features::JunctionCode::cross;
  report.detection.junction_px = features::PixelPoint{320.0, 240.0};
  report.detection.centroid_px = features::PixelPoint{319.0, 241.0};
  report.detection.foreground_ratio = 0.25;
  return report;
}

TEST(DetectionReport, HasTheFieldsOfTheContract) {
  const auto json = to_json(a_cross());
  const std::vector<std::string> contract = {
      "image",    "width",    "height",          "method",           "line",         "lines",
      "centroid", "junction", "junction_center", "foreground_ratio", "perception_ms"};
  for (const std::string& key : contract) EXPECT_TRUE(json.contains(key)) << key;
  for (const char* key : {"rho_px", "theta_deg", "x1", "y1", "x2", "y2"})
    EXPECT_TRUE(json["line"].contains(key)) << key;
  EXPECT_EQ(json["line"], json["lines"][0]);
  EXPECT_NEAR(json["line"]["rho_px"].get<double>(), 320.0, 1e-9);
  EXPECT_NEAR(json["line"]["theta_deg"].get<double>(), 0.0, 1e-9);
  EXPECT_NEAR(json["lines"][1]["theta_deg"].get<double>(), 90.0, 1e-9);
  EXPECT_EQ(json["junction"], "J3");
  EXPECT_EQ(json["junction_center"]["x_px"], 320.0);
  EXPECT_EQ(json["centroid"]["y_px"], 241.0);
  EXPECT_EQ(json["perception_ms"], 12.5);
  EXPECT_EQ(json["color"], "black");
}

TEST(DetectionReport, WhatWasNotSeenIsNull) {
  const auto json =
      to_json(DetectionReport{.image = "a.png", .method = "stripe", .detection = {}, .error = {}});
  for (const char* key : {"line", "centroid", "junction_center", "color"})
    EXPECT_TRUE(json[key].is_null()) << key;
  EXPECT_TRUE(json["lines"].is_array());
  EXPECT_TRUE(json["lines"].empty());
}

TEST(DetectionReport, AnErrorStandsAlone) {
  DetectionReport report = a_cross();
  report.error = "not an image";
  EXPECT_EQ(keys_of(to_json(report)), (std::vector<std::string>{"image", "error"}));
  EXPECT_THAT(to_text(report), HasSubstr("a.png: error: not an image"));
}

TEST(DetectionReport, TheTextNamesColourCodeAndLines) {
  const std::string text = to_text(a_cross());
  EXPECT_THAT(text, HasSubstr("black"));
  EXPECT_THAT(text, HasSubstr("J3"));
  EXPECT_THAT(text, HasSubstr("320.0"));
}

}  // namespace
}  // namespace lineservo::apps
