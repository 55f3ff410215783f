#include "apps/config/text_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/apps/test_files.h"

namespace lineservo::apps {
namespace {

using testing::complaint;
using ::testing::HasSubstr;
using testing::TempFolder;

TEST(IsUtf8, WellFormedTextIs) {
  for (const char* text : {"", "plain", "größer", "床の線", "\xF0\x9F\x9A\x81", "\xED\x9F\xBF",
                           "\xEF\xBF\xBF", "\xF4\x8F\xBF\xBF"})
    EXPECT_TRUE(is_utf8(text)) << text;
}

TEST(IsUtf8, StrayBytesOverlongFormsAndSurrogatesAreNot) {
  for (const char* text :
       {"\x80", "\xFF", "a\xC3", "\xC3z", "\xC0\xAF", "\xC1\xBF", "\xE0\x9F\xBF", "\xED\xA0\x80", "\xE2\x82",
        "\xF0\x8F\xBF\xBF", "\xF4\x90\x80\x80", "\xF5\x80\x80\x80"})
    EXPECT_FALSE(is_utf8(text));
}

TEST(ReadTextFile, IsTheTextOfAFileUpToItsLimit) {
  const TempFolder folder;
  EXPECT_EQ(read_text_file(folder.write("a", "x\ny")), "x\ny");
  EXPECT_EQ(read_text_file(folder.write("b", std::string(1 << 20, 'x'))).size(), 1u << 20);
  EXPECT_THAT(complaint([&] { read_text_file(folder.write("c", std::string((1 << 20) + 1, 'x'))); }),
              HasSubstr("1 MiB"));
  EXPECT_THAT(complaint([&] { read_text_file(folder.path()); }), HasSubstr("is a folder"));
  EXPECT_THAT(complaint([&] { read_text_file(folder.path() / "none"); }), HasSubstr("cannot be read"));
  EXPECT_THAT(complaint([&] { read_text_file("/dev/zero"); }), HasSubstr("1 MiB"));
  EXPECT_THAT(complaint([] { read_text_file(""); }), HasSubstr("'': is empty where the name of a file"));
}

TEST(ReadBytes, AFileThatBreaksOffCannotBeRead) {
  EXPECT_THAT(complaint([] { read_bytes("/proc/self/mem"); }), HasSubstr("/proc/self/mem: cannot be read"));
  EXPECT_THAT(complaint([] { read_bytes(""); }), HasSubstr("'': is empty where the name of a file"));
}

}  // namespace
}  // namespace lineservo::apps
