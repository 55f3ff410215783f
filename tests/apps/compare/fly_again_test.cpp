#include "apps/compare/fly_again.h"

#include <gtest/gtest.h>

namespace lineservo::apps {
namespace {

TEST(FlyAgain, IsTheWholeCommandQuotedForAShell) {
  Entry e;
  e.controller = "pid";
  e.layout = "my floors/bob's.yaml";
  e.speed_m_s = 0.1;
  e.tuned = true;
  e.overrides = {"camera.latency_s=0.06"};
  e.request.conditions = "paper";
  EXPECT_EQ(fly_again(e, "node:q", 42),
            "lineservo fly node:q --controller pid --layout 'my floors/bob'\\''s.yaml' --conditions paper "
            "--speed 0.1 --seed 42 --tuned --set camera.latency_s=0.06");
}

}  // namespace
}  // namespace lineservo::apps
