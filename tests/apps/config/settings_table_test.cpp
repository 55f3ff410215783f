#include "apps/config/settings_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <set>

#include "tests/apps/test_files.h"

namespace lineservo::apps {
namespace {

using ::testing::AllOf;
using testing::complaint;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

/// Low and high of "a number from 0.1 to 5", also of "a whole number from …"; nothing for other settings.
struct Range {
  bool known = false;
  double low = 0.0, high = 0.0;
};
Range range_of(const Setting& setting) {
  const std::size_t from = setting.allowed.find(" from "), to = setting.allowed.find(" to ");
  if (from == std::string::npos || to == std::string::npos) return {};
  return {true, std::stod(setting.allowed.substr(from + 6)), std::stod(setting.allowed.substr(to + 4))};
}
bool is_real(const Setting& setting) {
  return setting.allowed.starts_with("a number");
}

/// The shortest text that reads back to the same bits.
std::string text_of(double value) {
  char buffer[64];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr};
}

std::string set_complaint(const std::string& key, const std::string& text) {
  Settings settings;
  return complaint([&] { SettingsTable(settings).set(key, text, "--set"); });
}

TEST(SettingsTable, NoKeyStandsTwice) {
  Settings settings;
  std::set<std::string> keys;
  const SettingsTable table(settings);
  for (const Setting& s : table.all()) EXPECT_TRUE(keys.insert(s.key).second) << s.key;
  EXPECT_GT(keys.size(), 60u);
}

TEST(SettingsTable, HoldsTheNamesThatScriptsRelyOn) {
  Settings settings;
  std::set<std::string> keys;
  const SettingsTable table(settings);
  for (const Setting& s : table.all()) keys.insert(s.key);
  for (const char* key :
       {"speed_m_s", "camera.frame_rate_hz", "camera.latency_s", "features.junction.method",
        "features.line.method", "features.tilt_correction", "wind.mean_m_s", "servo.pid.kp"})
    EXPECT_TRUE(keys.contains(key)) << key;
}

TEST(SettingsTable, TheDefaultOfEverySettingIsAllowed) {
  Settings settings;
  const SettingsTable table(settings);
  for (const Setting& s : table.all()) EXPECT_TRUE(s.set(s.get())) << s.key << " = " << s.get();
}

TEST(SettingsTable, EveryNumberReadsBackToTheLastBit) {
  Settings settings, other;
  const SettingsTable table(settings), copy(other);
  for (std::size_t i = 0; i < table.all().size(); ++i) {
    const Setting& setting = table.all()[i];
    if (!is_real(setting)) continue;
    const Range range = range_of(setting);
    for (const double share : {1.0 / 3.0, 0.1, std::sqrt(0.5)}) {
      const double value = range.low + share * (range.high - range.low);
      ASSERT_TRUE(setting.set(text_of(value))) << setting.key;
      ASSERT_TRUE(copy.all()[i].set(setting.get())) << setting.key;
      EXPECT_EQ(copy.all()[i].get(), text_of(value)) << setting.key;
    }
  }
}

TEST(SettingsTable, EveryKeySetsAVariableOfItsOwn) {
  Settings settings;
  const SettingsTable table(settings);
  for (const Setting& changed : table.all()) {
    Settings fresh;
    const SettingsTable fresh_table(fresh);
    for (const Setting& s : fresh_table.all()) {
      if (s.key != changed.key || !range_of(s).known) continue;
      ASSERT_TRUE(
          s.set(s.get() == text_of(range_of(s).low) ? text_of(range_of(s).high) : text_of(range_of(s).low)));
    }
    for (std::size_t i = 0; i < table.all().size(); ++i) {
      const Setting& s = fresh_table.all()[i];
      if (s.key == changed.key) continue;
      EXPECT_EQ(s.get(), table.all()[i].get()) << changed.key << " changes " << s.key;
    }
  }
}

TEST(SettingsTable, BothBoundsAreAllowedAndWhatIsBeyondIsNot) {
  Settings settings;
  const SettingsTable table(settings);
  for (const Setting& s : table.all()) {
    const Range range = range_of(s);
    if (!range.known) continue;
    constexpr double kFar = std::numeric_limits<double>::infinity();
    EXPECT_TRUE(s.set(text_of(range.low))) << s.key;
    EXPECT_TRUE(s.set(text_of(range.high))) << s.key;
    EXPECT_FALSE(s.set(is_real(s) ? text_of(std::nextafter(range.low, -kFar)) : text_of(range.low - 1)))
        << s.key;
    EXPECT_FALSE(s.set(is_real(s) ? text_of(std::nextafter(range.high, kFar)) : text_of(range.high + 1)))
        << s.key;
  }
}

TEST(SettingsTable, NoSettingTakesWhatIsNoValueOfItsType) {
  Settings settings;
  const SettingsTable table(settings);
  for (const Setting& s : table.all()) {
    const std::string before = s.get();
    for (const char* text :
         {"", " ", "nan", "inf", "-inf", ".nan", "0x", "1,5", "1 ", " 1", "1e", "null", "1e999"})
      EXPECT_FALSE(s.set(text)) << s.key << " takes '" << text << "'";
    EXPECT_EQ(s.get(), before) << s.key;
  }
}

TEST(SettingsTable, WholeNumbersTakeNoFractions) {
  EXPECT_EQ(set_complaint("executive.confirm_frames", "2.5"),
            "--set: 'executive.confirm_frames' must be a whole number from 1 to 30, not '2.5'");
  EXPECT_EQ(set_complaint("features.junction.window", "4"),
            "--set: 'features.junction.window' must be one of 1, 3, 5, 7, 9, not '4'");
  EXPECT_EQ(set_complaint("features.junction.window", "7"), "no error");
}

TEST(SettingsTable, WordsAndSwitchesTakeTheirChoicesOnly) {
  EXPECT_EQ(set_complaint("features.junction.method", "fpd"), "no error");
  EXPECT_THAT(set_complaint("features.junction.method", "FPD"), HasSubstr("one of auto, fpd, stripe"));
  EXPECT_EQ(set_complaint("features.tilt_correction", "false"), "no error");
  EXPECT_THAT(set_complaint("features.tilt_correction", "no"), HasSubstr("must be true or false, not 'no'"));
}

TEST(SettingsTable, ABadValueNamesPlaceKeyAndWhatIsAllowed) {
  EXPECT_EQ(set_complaint("camera.frame_rate_hz", "0"),
            "--set: 'camera.frame_rate_hz' must be a number from 1 to 240, not '0'");
}

TEST(SettingsTable, AnUnknownKeyNamesThoseNearIt) {
  EXPECT_THAT(set_complaint("camera.frame_rate", "30"),
              AllOf(StartsWith("--set: unknown key 'camera.frame_rate'"), HasSubstr("camera.frame_rate_hz"),
                    Not(HasSubstr("wind"))));
  EXPECT_THAT(set_complaint("servo.pid.kq", "1"), HasSubstr("servo.pid.kp, servo.pid.ki, servo.pid.kd"));
  EXPECT_THAT(set_complaint("Camera.latency_s", "1"),
              HasSubstr("unknown key 'Camera.latency_s'; near it: camera.latency_s"));
  EXPECT_THAT(set_complaint("frame_rate_hz", "30"), HasSubstr("near it: camera.frame_rate_hz"));
  EXPECT_THAT(set_complaint("wind.mean_ms", "1"), HasSubstr("near it: wind.mean_m_s"));
}

}  // namespace
}  // namespace lineservo::apps
