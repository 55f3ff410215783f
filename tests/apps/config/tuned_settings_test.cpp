#include "apps/config/tuned_settings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/config/data_folder.h"
#include "servo/law/controllers.h"
#include "tests/apps/test_files.h"

namespace lineservo::apps {
namespace {

using ::testing::AllOf;
using testing::complaint;
using ::testing::HasSubstr;

FlightRequest request_of(const std::string& controller) {
  FlightRequest request;
  request.controller = controller;
  return request;
}

TEST(TunedSettings, AreTheLawsOwnAlone) {
  EXPECT_TRUE(is_law_key("pid", "servo.pid.kp"));
  EXPECT_FALSE(is_law_key("pid", "servo.ibvs.gain_at_zero"));
  EXPECT_FALSE(is_law_key("pid", "servo.dock.gain_at_zero"));
  EXPECT_TRUE(is_law_key("ibvs", "servo.dock.gain_at_zero"));
  EXPECT_FALSE(is_law_key("ibvs", "camera.latency_s"));
}

TEST(TunedSettings, ARefusedKeyNamesFileLineAndWhatIsAllowed) {
  const testing::TempFolder temp;
  const auto file = temp.write("pid.yaml", "servo.pid.kp: 1\nspeed_m_s: 1\n");
  FlightRequest request = request_of("pid");
  EXPECT_THAT(complaint([&] { apply_tuned(request, file); }),
              AllOf(HasSubstr("pid.yaml:2: 'speed_m_s'"), HasSubstr("servo.pid.*")));
}

TEST(TunedSettings, EveryLawHasThem) {
  for (const servo::Controller& c : servo::controllers()) {
    FlightRequest request = request_of(std::string(c.name));
    EXPECT_NO_THROW(apply_shipped_tuned(request, "--tuned")) << c.name;
  }
}

TEST(TunedSettings, AControllerWithoutAFileIsRefused) {
  EXPECT_FALSE(tuned_file("none"));
  FlightRequest request = request_of("none");
  EXPECT_THROW(apply_shipped_tuned(request, "--tuned"), std::invalid_argument);
}

}  // namespace
}  // namespace lineservo::apps
