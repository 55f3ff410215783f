#include "apps/config/program_files.h"

#include <gtest/gtest.h>

namespace lineservo::apps {
namespace {

namespace fs = std::filesystem;

TEST(ProgramFiles, LieUpwardFromTheModules) {
  const auto module = find_program_file({"liblineservo_image_codecs.so"});
  ASSERT_TRUE(module);
  EXPECT_EQ(find_program_file({"CMakeCache.txt"}), module->parent_path().parent_path() / "CMakeCache.txt");
}

TEST(ProgramFiles, AreThoseOfTheFirstPlaceThatThereIs) {
  const auto module = find_program_file({"no/such/file", "liblineservo_image_codecs.so", "CMakeCache.txt"});
  ASSERT_TRUE(module);
  EXPECT_EQ(module->filename(), "liblineservo_image_codecs.so");
}

TEST(ProgramFiles, AreNoneWhereNoneAre) {
  EXPECT_FALSE(find_program_file({"no/such/file"}));
  EXPECT_FALSE(find_program_file({}));
}

}  // namespace
}  // namespace lineservo::apps
