#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "apps/config/camera/camera_file.h"
#include "tests/apps/test_files.h"

namespace lineservo::apps::testing {

/// Tests of what a camera file is read as, or refused for.
class CameraFileTest : public ::testing::Test {
 protected:
  features::CameraParameters read(const std::string& text) const {
    return read_camera(temp_.write("camera", text));
  }
  std::string refusal(const std::string& text) const {
    return complaint([&] { read(text); });
  }

  const TempFolder temp_;
};

/// The text with the first `from` replaced; fails the test when there is none.
inline std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, text.npos) << from;
  return at == text.npos ? text : text.replace(at, from.size(), to);
}

}  // namespace lineservo::apps::testing
