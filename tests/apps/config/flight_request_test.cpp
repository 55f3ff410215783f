#include "apps/config/flight_request.h"
#include "apps/config/mission_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "apps/config/settings_table.h"
#include "apps/version.h"
#include "tests/apps/test_files.h"

namespace lineservo::apps {
namespace {

using ::testing::AllOf;
using testing::complaint;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using testing::TempFolder;

/// All settings as text, "key=value".
std::vector<std::string> texts(const FlightRequest& request) {
  FlightRequest copy = request;
  std::vector<std::string> list;
  const SettingsTable table(copy.settings);
  for (const Setting& s : table.all()) list.push_back(s.key + "=" + s.get());
  return list;
}

/// A request in which every setting that can be is off its default, by amounts that need all digits.
FlightRequest altered() {
  FlightRequest request;
  request.instruction = "a:12:3";
  request.controller = "pid";
  request.layout = "tape-warehouse";
  request.conditions = "ideal";
  request.seed = std::numeric_limits<std::uint64_t>::max();
  request.land = true;
  const SettingsTable table(request.settings);
  for (const Setting& s : table.all()) {
    if (!s.allowed.starts_with("a number")) continue;
    const double low = std::stod(s.allowed.substr(s.allowed.find(" from ") + 6));
    const double high = std::stod(s.allowed.substr(s.allowed.find(" to ") + 4));
    char text[64];
    std::snprintf(text, sizeof text, "%.17g", low + (high - low) / 3.0);
    EXPECT_TRUE(s.set(text)) << s.key;
  }
  return request;
}

class FlightRequestTest : public ::testing::Test {
 protected:
  FlightRequest reread(const FlightRequest& request) { return read(config_text(request)); }
  /// The default config with these lines of its first level in the place of its own.
  static std::string with(const std::vector<std::string>& lines) {
    std::string text = config_text(FlightRequest{});
    for (const std::string& line : lines) {
      const std::size_t at = ("\n" + text).find("\n" + line.substr(0, line.find(':') + 1));
      text.replace(at, text.find('\n', at) - at, line);
    }
    return text;
  }
  FlightRequest read(const std::string& text) { return read_config(folder_.write("config.yaml", text)); }
  std::string refusal(const std::string& text) {
    return complaint([&] { read(text); });
  }
  std::string at(int line) const {
    return (folder_.path() / "config.yaml").string() + ":" + std::to_string(line) + ": ";
  }
  FlightRequest with_conditions(const std::string& text, FlightRequest request = {}) {
    apply_conditions(request, folder_.write("conditions.yaml", text).string());
    return request;
  }

  TempFolder folder_;
};

TEST_F(FlightRequestTest, ConfigReadsBackEverySettingOfTheDefaults) {
  EXPECT_EQ(texts(reread({})), texts({}));
}

TEST_F(FlightRequestTest, ConfigReadsBackEverySettingToTheLastBit) {
  const FlightRequest request = altered(), again = reread(request);
  EXPECT_EQ(texts(again), texts(request));
  EXPECT_EQ(again.instruction, "a:12:3");
  EXPECT_EQ(again.controller, "pid");
  EXPECT_EQ(again.layout, "tape-warehouse");
  EXPECT_EQ(again.conditions, "ideal");
  EXPECT_EQ(again.seed, std::numeric_limits<std::uint64_t>::max());
  EXPECT_TRUE(again.land);
  EXPECT_EQ(config_text(again), config_text(request));
}

TEST_F(FlightRequestTest, ConfigHoldsTheVersionAndEveryKey) {
  FlightRequest request;
  const std::string text = config_text(request);
  EXPECT_THAT(text, StartsWith("version: " + std::string(kVersion)));
  EXPECT_THAT(text, HasSubstr("\nseed: 1\n"));
  EXPECT_THAT(text, HasSubstr("\ncamera:\n"));
  EXPECT_THAT(text, HasSubstr("\n  frame_rate_hz: 30\n"));
}

TEST_F(FlightRequestTest, PathsWithSignsOfYamlReadBack) {
  FlightRequest request;
  for (const char* path :
       {"my floors/hall: 2 #3.yaml", "[hall].yaml", "'hall'.yaml", "\"hall\".yaml", "*hall.yaml",
        "- hall.yaml", "~", "null", "C:\\floors\\hall.yaml", "node:p", " hall.yaml "}) {
    request.layout = request.instruction = request.conditions = path;
    const FlightRequest again = reread(request);
    EXPECT_EQ(again.layout, folder_.path() / path);
    EXPECT_EQ(again.instruction, is_mission_file(path) ? (folder_.path() / path).string() : path);
    EXPECT_EQ(again.conditions, folder_.path() / path);
  }
}

TEST_F(FlightRequestTest, PathsOfAConfigAreThoseFromItsFolder) {
  EXPECT_EQ(read(with({"layout: layout.yaml"})).layout, folder_.path() / "layout.yaml");
  EXPECT_EQ(read(with({"layout: /floors/hall.yaml"})).layout, "/floors/hall.yaml");
  const FlightRequest shipped = read(with({"layout: bend", "conditions: ideal"}));
  EXPECT_EQ(shipped.layout, "bend");
  EXPECT_EQ(shipped.conditions, "ideal");
}

// A default in the place of a missing key would fly another flight than the one that the config is of.
TEST_F(FlightRequestTest, AConfigHoldsEveryKey) {
  EXPECT_EQ(refusal("instruction: a13\n"),
            (folder_.path() / "config.yaml").string() +
                ": key 'version' is missing; a config.yaml holds every setting of its flight");
  const std::string whole = config_text(FlightRequest{});
  for (const std::string line : {"seed: 1", "land: false", "layout: \"warehouse\"", "speed_m_s: 0.3"}) {
    std::string text = whole;
    text.erase(text.find(line), line.size());
    EXPECT_THAT(refusal(text), HasSubstr("key '" + line.substr(0, line.find(':')) + "' is missing"));
  }
  std::string text = whole;
  text.erase(text.find("  latency_s: 0"), 14);
  EXPECT_THAT(refusal(text), HasSubstr("key 'camera.latency_s' is missing"));
}

TEST_F(FlightRequestTest, AConfigIsOfThisVersion) {
  EXPECT_EQ(
      refusal(with({"version: 0.0.9"})),
      at(1) + "is of version 0.0.9, which need not fly as this one does; allowed: " + std::string(kVersion));
}

TEST_F(FlightRequestTest, BadSeedsAreRefused) {
  for (const char* seed : {"-1", "1.5", "one", "18446744073709551616", "0x10", "'1 '"}) {
    EXPECT_EQ(refusal(std::string("instruction: a13\nseed: ") + seed + "\n"),
              at(2) + "'seed' must be a whole number from 0 to 18446744073709551615")
        << seed;
  }
  EXPECT_EQ(read(with({"seed: 0"})).seed, 0u);
}

TEST_F(FlightRequestTest, LandIsTrueOrFalse) {
  EXPECT_EQ(refusal("land: yes\n"), at(1) + "'land' must be true or false");
  EXPECT_TRUE(read(with({"land: true"})).land);
}

TEST_F(FlightRequestTest, AnUnknownKeyOrBadValueNamesFileLineAndKey) {
  EXPECT_THAT(refusal("instruction: a13\ncamera:\n  latency: 1\n"),
              AllOf(StartsWith(at(3) + "unknown key 'camera.latency'"), HasSubstr("camera.latency_s")));
  EXPECT_EQ(refusal("speed_m_s: fast\n"), at(1) + "'speed_m_s' must be a number from 0.01 to 2, not 'fast'");
  EXPECT_EQ(refusal("speed_m_s: .nan\n"), at(1) + "'speed_m_s' must be a number from 0.01 to 2, not '.nan'");
}

TEST_F(FlightRequestTest, ConditionsOverlayOnlyWhatTheyName) {
  const FlightRequest before = altered();
  const FlightRequest after =
      with_conditions("description: some\nspeed_m_s: 0.7\nwind: {mean_m_s: 1.25}\n", before);
  std::vector<std::string> changed;
  for (std::size_t i = 0; i < texts(before).size(); ++i) {
    if (texts(before)[i] != texts(after)[i]) changed.push_back(texts(after)[i]);
  }
  EXPECT_THAT(changed, ::testing::ElementsAre("speed_m_s=0.7", "wind.mean_m_s=1.25"));
  EXPECT_EQ(after.instruction, before.instruction);
  EXPECT_EQ(after.seed, before.seed);
  EXPECT_EQ(after.conditions, (folder_.path() / "conditions.yaml").string());
}

TEST_F(FlightRequestTest, ConditionsHoldSettingsOnly) {
  EXPECT_THAT(complaint([&] { with_conditions("seed: 3\n"); }),
              HasSubstr("conditions.yaml:1: unknown key 'seed'"));
  EXPECT_THAT(complaint([&] { with_conditions("speed_m_s: 0.1\ninstruction: a13\n"); }),
              HasSubstr("conditions.yaml:2: unknown key 'instruction'"));
}

TEST_F(FlightRequestTest, PaperIsAsInTheTableOfConditions) {
  FlightRequest request;
  apply_conditions(request, "paper");
  const Settings& s = request.settings;
  EXPECT_EQ(s.speed_m_s, 0.1);
  EXPECT_EQ(s.camera.frame_rate_hz, 10.0);
  EXPECT_EQ(s.camera.latency_s, 0.05);
  EXPECT_EQ(s.camera.latency_error_s, 0.01);
  EXPECT_EQ(s.camera.noise_levels, 2.0);
  EXPECT_EQ(s.wind.mean_m_s, 0.0);
  EXPECT_EQ(s.sensors.gyro_sigma_deg_s, 0.1);
  EXPECT_EQ(s.sensors.gyro_bias_deg_s, 0.05);
  EXPECT_EQ(s.sensors.accelerometer_sigma_m_s2, 0.05);
  EXPECT_EQ(s.sensors.accelerometer_bias_m_s2, 0.05);
  EXPECT_EQ(s.sensors.attitude_sigma_deg, 0.2);
  EXPECT_EQ(s.sensors.velocity_sigma_m_s, 0.03);
  EXPECT_EQ(s.sensors.range_sigma_m, 0.005);
}

TEST_F(FlightRequestTest, HarshIsAsInTheTableOfConditions) {
  FlightRequest request;
  apply_conditions(request, "harsh");
  const Settings& s = request.settings;
  EXPECT_EQ(s.speed_m_s, 0.5);
  EXPECT_EQ(s.camera.frame_rate_hz, 30.0);
  EXPECT_EQ(s.camera.latency_s, 0.06);
  EXPECT_GT(s.camera.latency_jitter_s, 0.0);
  EXPECT_LE(s.camera.latency_jitter_s + s.camera.latency_error_s, 0.01);
  EXPECT_EQ(s.camera.drop_share, 0.05);
  EXPECT_EQ(s.camera.shutter.exposure_s, 0.008);
  EXPECT_EQ(s.camera.shutter.samples, 5);
  EXPECT_EQ(s.camera.shutter.readout_s, 0.015);
  EXPECT_EQ(s.camera.noise_levels, 6.0);
  EXPECT_EQ(s.camera.mount_tilt_deg, 1.0);
  EXPECT_EQ(s.floor.light.low, 0.4);
  EXPECT_EQ(s.floor.light.high, 1.3);
  EXPECT_GT(s.floor.light.glare, 0.0);
  EXPECT_EQ(s.floor.wear.worn_share, 0.25);
  EXPECT_EQ(s.floor.wear.gap_m, 0.1);
  EXPECT_GT(s.floor.wear.dirt_share, 0.0);
  EXPECT_EQ(s.wind.mean_m_s, 1.5);
  EXPECT_EQ(s.wind.turbulence_m_s, 0.8);
  EXPECT_EQ(s.sensors.velocity_bias_m_s, 0.03);
  EXPECT_EQ(s.sensors.tilt_bias_deg, 0.5);
  EXPECT_EQ(s.sensors.range_sigma_m, 0.02);
  EXPECT_EQ(s.airframe.load_factor, 1.1);
}

TEST_F(FlightRequestTest, IdealIsAsInTheTableOfConditionsAndTheDefault) {
  FlightRequest request;
  apply_conditions(request, "ideal");
  EXPECT_EQ(texts(request), texts({}));
  EXPECT_EQ(request.settings.speed_m_s, 0.3);
  EXPECT_EQ(request.settings.camera.frame_rate_hz, 30.0);
  EXPECT_EQ(request.settings.camera.latency_s, 0.0);
  EXPECT_EQ(request.settings.sensors.velocity_sigma_m_s, 0.0);
}

TEST_F(FlightRequestTest, TheVehicleStartsWithinTheBoundsOfTheSpecification) {
  EXPECT_EQ(FlightRequest{}.settings.start.position_spread_m, 0.10);
  EXPECT_EQ(FlightRequest{}.settings.start.heading_spread_deg, 5.0);
}

TEST(ApplyOverride, SetsOneKey) {
  FlightRequest request;
  apply_override(request, "camera.frame_rate_hz=12.5");
  EXPECT_EQ(request.settings.camera.frame_rate_hz, 12.5);
}

TEST(ApplyOverride, NeedsKeyAndValue) {
  FlightRequest request;
  for (const char* text : {"", "=", "=3", "speed_m_s"})
    EXPECT_THAT(complaint([&] { apply_override(request, text); }), HasSubstr("must be KEY=VALUE")) << text;
  EXPECT_THAT(complaint([&] { apply_override(request, "speed_m_s="); }), HasSubstr("'speed_m_s' must be"));
  EXPECT_THAT(complaint([&] { apply_override(request, "speed_m_s=0.1=0.2"); }),
              HasSubstr("'speed_m_s' must be"));
  EXPECT_THAT(complaint([&] { apply_override(request, "seed=2"); }), HasSubstr("unknown key 'seed'"));
}

TEST(FlightRequest, EachZoneHasItsFloor) {
  EXPECT_EQ(layout_of_zone("a13"), "warehouse");
  EXPECT_EQ(layout_of_zone("b02"), "square");
  EXPECT_EQ(layout_of_zone("c07"), "octagon");
  EXPECT_EQ(layout_of_zone("d00"), "circle");
  EXPECT_EQ(layout_of_zone("node:dock7"), "warehouse");
  EXPECT_EQ(layout_of_zone(""), "warehouse");
}

}  // namespace
}  // namespace lineservo::apps
