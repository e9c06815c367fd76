#include "textures/base/utf8.h"

#include <gtest/gtest.h>

namespace moontrace {
namespace {

TEST(FirstBadUtf8, TakesEveryWellFormedLength) {
  EXPECT_EQ(FirstBadUtf8(""), std::nullopt);
  EXPECT_EQ(FirstBadUtf8("a\xC3\xA9\xE4\xB8\x80\xF0\x9F\x98\x80\xEF\xBB\xBF"), std::nullopt);
  EXPECT_EQ(FirstBadUtf8("\xED\x9F\xBF\xEE\x80\x80\xF4\x8F\xBF\xBF"), std::nullopt);
}

TEST(FirstBadUtf8, FindsWhatUnicodeForbids) {
  // Unicode, table 3-7: overlong, surrogate, beyond U+10FFFF, lone and missing trailing bytes.
  for (const char* bad : {"\xC0\x80", "\xC1\xBF", "\xE0\x9F\xBF", "\xED\xA0\x80",
                          "\xF0\x8F\xBF\xBF", "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\x80",
                          "\xC3", "\xE4\xB8", "\xF0\x9F\x98", "\xFF"}) {
    EXPECT_EQ(FirstBadUtf8(std::string("ab") + bad), 2U);
  }
}

}  // namespace
}  // namespace moontrace
