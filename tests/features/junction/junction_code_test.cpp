#include "features/junction/junction_code.h"

#include <gtest/gtest.h>

namespace lineservo::features {
namespace {

struct Case {
  Arms arms;  // forward, back, left, right
  std::string_view code;
};

class CodeOfArms : public testing::TestWithParam<Case> {};

TEST_P(CodeOfArms, FollowsTheTable) {
  EXPECT_EQ(name(code_of(GetParam().arms)), GetParam().code);
}

INSTANTIATE_TEST_SUITE_P(
    All, CodeOfArms,
    testing::Values(Case{{true, true, true, true}, "J3"}, Case{{false, true, true, true}, "J7"},
                    Case{{true, false, true, true}, "J6"}, Case{{true, true, false, true}, "J8"},
                    Case{{true, true, true, false}, "J9"}, Case{{false, true, false, true}, "J4"},
                    Case{{true, false, false, true}, "J4"}, Case{{false, true, true, false}, "J5"},
                    Case{{true, false, true, false}, "J5"}, Case{{true, true, false, false}, "J2"},
                    Case{{true, false, false, false}, "J2"}, Case{{false, true, false, false}, "J2"},
                    Case{{false, false, true, false}, "J2"}, Case{{false, false, false, true}, "J2"},
                    Case{{false, false, true, true}, "J1"}, Case{{false, false, false, false}, "J1"}));

}  // namespace
}  // namespace lineservo::features
