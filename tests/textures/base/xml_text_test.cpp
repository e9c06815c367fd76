#include "textures/base/xml_text.h"

#include <gtest/gtest.h>

namespace moontrace {
namespace {

// XML 1.0, section 4.6: the predefined entities.
TEST(XmlText, NamesWhatWouldEndTextOrAttribute) {
  EXPECT_EQ(EscapedXml("a<b> & \"c\""), "a&lt;b&gt; &amp; &quot;c&quot;");
  EXPECT_EQ(EscapedXml("&amp;"), "&amp;amp;");
}

TEST(XmlText, LeavesTheRest) {
  EXPECT_EQ(EscapedXml("it's \n \xc3\xa9"), "it's \n \xc3\xa9");
  EXPECT_EQ(EscapedXml(""), "");
}

}  // namespace
}  // namespace moontrace
