#include "textures/fonts/glyph_name.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace moontrace {
namespace {

TEST(FontGlyphName, NumbersWhatFontEditorsDoNotTake) {
  // By the Adobe Glyph List Specification, section 6: "uni" and four digits a character, "u" and
  // four to six for one, "_" between components.
  for (const auto& [name, written] : {
           std::pair<std::string, std::string>{"h.reverse-n", "h.reverse-n"},
           {"A", "A"},
           {"\"", "uni0022"},
           {"&", "uni0026"},
           {"0", "uni0030"},
           {"#95", "uni002300390035"},
           {"\u6728", "uni6728"},
           {"\U0001F600", "u1F600"},
           {"a\U0001F600b c", "uni0061_u1F600_uni006200200063"},
       }) {
    EXPECT_EQ(FontGlyphName(name), written);
    EXPECT_EQ(CharactersNamed(written), written == name ? "" : name);
  }
}

TEST(CharactersNamed, IsEmptyForNamesThatNumberNothingToBeShown) {
  for (const char* name :
       {"", "uni", "uni22", "uni00a4", "union", "uniD800", "uniD83DDE00", "uni0007", "u110000",
        "u0022_", "_", "u12", "uni0022.alt", "uni200B", "a_uni0022"}) {
    EXPECT_EQ(CharactersNamed(name), "") << name;
  }
}

}  // namespace
}  // namespace moontrace
