#include "textures/base/case_fold.h"

#include <gtest/gtest.h>

namespace moontrace {
namespace {

// Unicode's CaseFolding.txt, statuses C and F.
TEST(CaseFolded, IsAlikeForNamesThatDifferByCapitalsOnly) {
  EXPECT_EQ(CaseFolded("Ada"), CaseFolded("aDA"));
  EXPECT_EQ(CaseFolded("\u00c5sa"), CaseFolded("\u00e5SA"));
  EXPECT_EQ(CaseFolded("A\u030asa"), CaseFolded("\u00e5sa"));  // composed or not
  EXPECT_EQ(CaseFolded("STRASSE"), CaseFolded("stra\u00dfe"));
  EXPECT_EQ(CaseFolded("\u03a3\u03bf\u03c6\u03af\u03b1\u03c2"),
            CaseFolded("\u03c3\u03bf\u03c6\u03af\u03b1\u03c3"));
  EXPECT_NE(CaseFolded("Ada"), CaseFolded("Ida"));
  EXPECT_NE(CaseFolded("Jose"), CaseFolded("Jos\u00e9"));
}

TEST(CaseFolded, KeepsWhatIsNoText) {
  EXPECT_EQ(CaseFolded(""), "");
  EXPECT_EQ(CaseFolded("A\xff"), "A\xff");
}

}  // namespace
}  // namespace moontrace
