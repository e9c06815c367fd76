#include "sim/html_report/gallery_page.h"

#include <gtest/gtest.h>

namespace moontrace {
namespace {

TEST(GalleryPage, KeepsWhatWordsSayFromBecomingMarkup) {
  const std::string page = GalleryPage({{"A & B", "moontrace page \"<b>\"", "1.svg", "x < y"}});
  EXPECT_NE(page.find("<h2>A &amp; B</h2>"), std::string::npos);
  EXPECT_NE(page.find("<code>moontrace page &quot;&lt;b&gt;&quot;</code>"), std::string::npos);
  EXPECT_NE(page.find("<pre>x &lt; y</pre>"), std::string::npos);
}

TEST(GalleryPage, ShowsNoPictureWhereThereIsNone) {
  const std::string page = GalleryPage({{"Lacking", "moontrace page a", "", "no font"}});
  EXPECT_EQ(page.find("<img"), std::string::npos);
  EXPECT_NE(page.find("no font"), std::string::npos);
}

}  // namespace
}  // namespace moontrace
