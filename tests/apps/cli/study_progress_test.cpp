#include "apps/cli/study_progress.h"

#include <gtest/gtest.h>

namespace lineservo::apps {
namespace {

TEST(ClockText, IsMinutesAndSecondsWithHoursWhereThereAreAny) {
  EXPECT_EQ(clock_text(0.0), "0:00");
  EXPECT_EQ(clock_text(61.2), "1:02");
  EXPECT_EQ(clock_text(3599.0), "59:59");
  EXPECT_EQ(clock_text(3723.0), "1:02:03");
}

}  // namespace
}  // namespace lineservo::apps
