#include "apps/recording/recording_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "apps/recording/digest.h"
#include "tests/apps/test_files.h"

namespace lineservo::apps {
namespace {

using ::testing::HasSubstr;

RecordedTick odd_tick() {
  RecordedTick tick;
  tick.input.now = servo::Time(123456789012345678);
  tick.input.roll_rad = 0.1;
  tick.input.pitch_rad = -0.0;
  tick.input.estimate.height_m = std::numeric_limits<double>::denorm_min();
  tick.input.estimate.v_H_m_s = {1.0 / 3.0, std::numeric_limits<double>::quiet_NaN(), -1e300};
  tick.input.on_ground = true;
  tick.estimates_sha256 = "e";
  tick.frame = "000000.png";
  tick.frame_sha256 = "f";
  tick.outputs = {{row_of(servo::VelocityCommand{0.1, 0.2, 0.3, 2.0 / 3.0}), "c", "s"},
                  {row_of(servo::AttitudeCommand{0.1, -0.2, 0.3, 0.5}), "d", "t"}};
  return tick;
}

const std::vector<std::string> kControllers = {"ibvs", "lfpf"};

TEST(RecordingTable, ReadsBackToTheLastBit) {
  const testing::TempFolder temp;
  const RecordedTick tick = odd_tick();
  const auto file = temp.write("t.csv", recording_header(kControllers) + recording_row(tick));
  const std::vector<RecordedTick> ticks = read_recording_table(file, kControllers);
  ASSERT_EQ(ticks.size(), 1u);
  EXPECT_EQ(digest(ticks[0].input), digest(tick.input));
  EXPECT_TRUE(std::signbit(ticks[0].input.pitch_rad));
  EXPECT_EQ(ticks[0].estimates_sha256, "e");
  EXPECT_EQ(ticks[0].frame, "000000.png");
  EXPECT_EQ(ticks[0].frame_sha256, "f");
  ASSERT_EQ(ticks[0].outputs.size(), 2u);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(digest(ticks[0].outputs[k].command), digest(tick.outputs[k].command));
    EXPECT_EQ(ticks[0].outputs[k].command_sha256, tick.outputs[k].command_sha256);
    EXPECT_EQ(ticks[0].outputs[k].features_sha256, tick.outputs[k].features_sha256);
  }
}

TEST(RecordingTable, NamesTheLineAndColumnThatIsNone) {
  const testing::TempFolder temp;
  const std::string header = recording_header(kControllers), row = recording_row(odd_tick());
  const auto reading = [&](const std::string& text) {
    const auto file = temp.write("t.csv", text);
    return testing::complaint([&] { read_recording_table(file, kControllers); });
  };
  EXPECT_THAT(reading(header + row + "x" + row), HasSubstr("t.csv:3: t_ns 'x1234"));
  EXPECT_THAT(reading(header + row.substr(0, row.size() - 1) + ",1\n"),
              HasSubstr("t.csv:2: has more columns"));
  EXPECT_THAT(reading(header + row.substr(0, 40) + "\n"), HasSubstr("t.csv:2: column"));
  EXPECT_THAT(reading(header + row.substr(0, 40)), HasSubstr("t.csv:2: the line is cut short"));
  EXPECT_THAT(reading(""), HasSubstr("t.csv:1: is not the header"));
  EXPECT_THAT(reading(recording_header({"ibvs"})), HasSubstr("t.csv:1: is not the header"));
}

}  // namespace
}  // namespace lineservo::apps
