#include "apps/report/report_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

namespace lineservo::apps {
namespace {

const std::string kPage = "<title>@REPORT_TITLE@</title><script>@REPORT_DATA@</script>";

TEST(ReportPage, HoldsTitleAndData) {
  EXPECT_EQ(filled_page(kPage, "a13", "[1]"), "<title>a13</title><script>[1]</script>");
}

TEST(ReportPage, ATitleIsText) {
  EXPECT_EQ(filled_page(kPage, "<b> & @REPORT_DATA@", "1"),
            "<title>&lt;b> &amp; @REPORT_DATA@</title><script>1</script>");
}

TEST(ReportPage, NoDataEndTheScript) {
  const nlohmann::json data = "</script><!-- <script>";
  const std::string page = filled_page(kPage, "t", data.dump());
  const std::size_t begin = page.find("<script>") + 8;
  const std::string script = page.substr(begin, page.find("</script>") - begin);
  EXPECT_EQ(nlohmann::json::parse(script), data);
  EXPECT_TRUE(page.ends_with(script + "</script>"));
}

TEST(ReportPage, APageWithoutAPlaceForThemIsRefused) {
  EXPECT_THROW(filled_page("<title>@REPORT_TITLE@</title>", "t", "1"), std::logic_error);
  EXPECT_THROW(filled_page("@REPORT_DATA@", "t", "1"), std::logic_error);
}

TEST(ReportPage, TheBuiltPageHasItsPlacesAndNeedsNoOtherFile) {
  const auto page = find_report_page();
  if (!page) GTEST_SKIP() << "the page was not built: npm was not to be had";
  const std::string filled = filled_page(*page, "t", "{}");
  EXPECT_THAT(filled, ::testing::HasSubstr("<title>t</title>"));
  for (const char* reference : {"<script src", "<link rel=\"stylesheet", "@import", "@SCRIPT@", "@STYLE@"})
    EXPECT_THAT(filled, ::testing::Not(::testing::HasSubstr(reference)));
}

}  // namespace
}  // namespace lineservo::apps
