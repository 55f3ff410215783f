#include "apps/output/json_text.h"

#include <gtest/gtest.h>

namespace lineservo::apps {
namespace {

TEST(JsonText, IsOneLineOrIndentedInTheOrderOfTheKeys) {
  const nlohmann::ordered_json json = {{"b", 1}, {"a", "é"}};
  EXPECT_EQ(json_text(json), "{\"b\":1,\"a\":\"é\"}\n");
  EXPECT_EQ(json_text(json, 2), "{\n  \"b\": 1,\n  \"a\": \"é\"\n}\n");
}

TEST(JsonText, WhatIsNotUtf8IsReplaced) {
  EXPECT_EQ(json_text({{"image", "\xff.png"}}), "{\"image\":\"\xEF\xBF\xBD.png\"}\n");
}

}  // namespace
}  // namespace lineservo::apps
