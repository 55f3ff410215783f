#include "apps/module/module_function.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace lineservo::apps {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string complaint_about(const char* module, const char* symbol) try {
  module_symbol(module, symbol, "codecs");
  return "";
} catch (const std::runtime_error& error) {
  return error.what();
}

TEST(ModuleFunction, IsThatOfTheModule) {
  EXPECT_NE(module_symbol("liblineservo_image_codecs.so", "lineservo_encode_image", "codecs"), nullptr);
}

TEST(ModuleFunction, SaysWhatDoesNotLoadAndWhy) {
  const std::string no_module = complaint_about("liblineservo_none.so", "lineservo_encode_image");
  EXPECT_THAT(no_module, StartsWith("the codecs do not load: "));
  EXPECT_THAT(no_module, HasSubstr("liblineservo_none.so"));
  const std::string no_symbol = complaint_about("liblineservo_image_codecs.so", "lineservo_nothing");
  EXPECT_THAT(no_symbol, StartsWith("the codecs do not load: "));
  EXPECT_THAT(no_symbol, HasSubstr("lineservo_nothing"));
}

}  // namespace
}  // namespace lineservo::apps
