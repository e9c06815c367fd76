#include "sim/reading/read_text.h"

#include <gtest/gtest.h>

#include "textures/fonts/script_library.h"

namespace moontrace {
namespace {

class ReadText : public testing::Test {
 protected:
  ReadToken Sign(const char* name) const {
    ReadToken token;
    token.glyph = script_.Find(name);
    return token;
  }
  static ReadToken Other(ReadToken::Kind kind) {
    ReadToken token;
    token.kind = kind;
    return token;
  }
  Script script_ = FindScript("moon");
};

TEST_F(ReadText, IsTheLettersOfTheSigns) {
  EXPECT_EQ(TextRead({Sign("h.arc"), Sign("i"), Other(ReadToken::Kind::kSpace), Sign("comma"),
                      Other(ReadToken::Kind::kLineEnd), Sign("th")},
                     script_),
            "hi ,\nthe");
  EXPECT_EQ(TextRead({Sign("th"), Sign("i"), Sign("n")}, script_), "thin");
}

TEST_F(ReadText, HasDigitsBehindTheNumeralSignUpToASpace) {
  EXPECT_EQ(
      TextRead({Sign("numeral"), Sign("a"), Sign("j"), Other(ReadToken::Kind::kSpace), Sign("a")},
               script_),
      "10 a");
}

TEST_F(ReadText, SaysWhatWasNotKnown) {
  EXPECT_EQ(TextRead({Sign("o"), Other(ReadToken::Kind::kUnknown)}, script_), "o\xEF\xBF\xBD");
}

}  // namespace
}  // namespace moontrace
