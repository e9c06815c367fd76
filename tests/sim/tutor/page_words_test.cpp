#include "sim/tutor/page_words.h"

#include <gtest/gtest.h>

#include <numbers>

#include "sim/tutor/page_messages.h"
#include "textures/base/text_file.h"

namespace moontrace {
namespace {

PageCommand Read(PageWord word, std::string_view behind) {
  const auto read = ReadPageCommand(word, behind);
  if (const std::string* refusal = std::get_if<std::string>(&read)) {
    ADD_FAILURE() << *refusal;
    return {};
  }
  return std::get<PageCommand>(read);
}

std::string Refused(PageWord word, std::string_view behind) {
  const auto read = ReadPageCommand(word, behind);
  const std::string* refusal = std::get_if<std::string>(&read);
  return refusal == nullptr ? std::string() : *refusal;
}

TEST(PageWords, TakeNumbersWithTheirUnitOrWithout) {
  EXPECT_DOUBLE_EQ(Read(PageWord::kSize, "20").value, 0.020);
  EXPECT_DOUBLE_EQ(Read(PageWord::kSize, "20 mm").value, 0.020);
  EXPECT_DOUBLE_EQ(Read(PageWord::kSize, "2CM").value, 0.020);
  EXPECT_DOUBLE_EQ(Read(PageWord::kSize, "0.02 m").value, 0.020);
  EXPECT_DOUBLE_EQ(Read(PageWord::kDepth, "50%").value, 0.5);
  EXPECT_DOUBLE_EQ(Read(PageWord::kDepth, "50").value, 0.5);
  EXPECT_DOUBLE_EQ(Read(PageWord::kDepth, "150 percent").value, 1.5);
  EXPECT_DOUBLE_EQ(Read(PageWord::kWidth, "120 %").value, 1.2);
  EXPECT_DOUBLE_EQ(Read(PageWord::kSpacing, "+1.5").value, 1.5);
  EXPECT_DOUBLE_EQ(Read(PageWord::kPitch, "1.5 times").value, 1.5);
  EXPECT_DOUBLE_EQ(Read(PageWord::kTilt, "-60 degrees").value, -std::numbers::pi / 3);
}

TEST(PageWords, TakeTheEndsOfARangeAndNothingBeyond) {
  struct Range {
    PageWord word;
    const char *low, *high, *below, *above;
  };
  for (const Range& range : {Range{PageWord::kSize, "1", "1 m", "0.9", "1001 mm"},
                             Range{PageWord::kDepth, "20 %", "2", "0.1", "201 %"},
                             Range{PageWord::kWidth, "50 %", "2", "49 %", "201 %"},
                             Range{PageWord::kSpacing, "1", "300 %", "0.9", "301 %"},
                             Range{PageWord::kPitch, "100 %", "3", "99 %", "3.1"},
                             Range{PageWord::kTilt, "-60", "60 degrees", "-61", "1e300"}}) {
    EXPECT_EQ(Refused(range.word, range.low), "") << range.low;
    EXPECT_EQ(Refused(range.word, range.high), "") << range.high;
    for (const char* outside : {range.below, range.above}) {
      EXPECT_NE(Refused(range.word, outside).find("out of range"), std::string::npos) << outside;
    }
  }
  EXPECT_EQ(Refused(PageWord::kSize, "0.9"), "No size 0.9, out of range: it wants mm, 1 to 1000.");
}

TEST(PageWords, RefuseWhatIsNoneOfTheirs) {
  for (const char* given :
       {"big", "20 inches", "nan", "inf", "20 30", "1,5", "0x1p0", "20 %", "--20"}) {
    EXPECT_NE(Refused(PageWord::kSize, given).find("No size "), std::string::npos) << given;
  }
  EXPECT_EQ(Refused(PageWord::kTilt, "5 %"), "No tilt 5 %: it wants degrees, -60 to 60.");
  EXPECT_EQ(Refused(PageWord::kDepth, "3"), "No depth 3, out of range: it wants 20 to 200 %.");
  EXPECT_EQ(Refused(PageWord::kDepth, ""), "depth lacks what it wants: 20 to 200 %.");
  EXPECT_EQ(Refused(PageWord::kPaper, "sampled"),
            "No paper sampled: it wants smooth, sine, grid or noise.");
  EXPECT_EQ(Refused(PageWord::kPaper, ""),
            "paper lacks what it wants: smooth, sine, grid or noise.");
  EXPECT_EQ(Refused(PageWord::kForm, ""),
            "form lacks what it wants: crescent, arc, pocket or reverse-n.");
  EXPECT_EQ(Refused(PageWord::kEngraved, "2"), "Say engraved alone, without 2.");
}

TEST(PageWords, TakeNamesInAnyCapitals) {
  EXPECT_EQ(Read(PageWord::kForm, "Reverse N").h_form, "reverse-n");
  EXPECT_EQ(Read(PageWord::kForm, "arc").h_form, "arc");
  EXPECT_EQ(Read(PageWord::kPaper, "SINE").paper, PaperKind::kSine);
  EXPECT_EQ(Read(PageWord::kPaper, "grid").paper, PaperKind::kGrid);
  EXPECT_EQ(Read(PageWord::kPaper, "smooth").paper, std::nullopt);
}

TEST(PageWords, ChangeOnePartOfTheFormEach) {
  PageForm form;
  form.depth = 0.5;
  form.paper = PaperKind::kNoise;
  PageForm expected = form;
  expected.width = 1.2;
  form = Changed(form, Read(PageWord::kWidth, "120 %"));
  EXPECT_EQ(form, expected);
  expected.relief = Relief::kEmbossed;
  form = Changed(form, Read(PageWord::kEmbossed, ""));
  EXPECT_EQ(form, expected);
  expected.pitch = 1.5;
  form = Changed(form, Read(PageWord::kPitch, "150 %"));
  EXPECT_EQ(form, expected);
  expected.paper = std::nullopt;
  expected.h_form = "pocket";
  form = Changed(Changed(form, Read(PageWord::kPaper, "smooth")), Read(PageWord::kForm, "pocket"));
  EXPECT_EQ(form, expected);
  EXPECT_EQ(Changed(form, Read(PageWord::kSize, "20")), expected);
  EXPECT_EQ(Changed(form, Read(PageWord::kTilt, "20")), expected);
}

TEST(PageWords, AndTheirRefusalsKeepToALine) {
  const std::string long_one(300, 'x');
  for (std::size_t i = 0; i < PageWords().size(); ++i) {
    const auto word = static_cast<PageWord>(i);
    for (const std::string& given : {std::string(), long_one, std::string("100000000000000000")}) {
      EXPECT_LE(CountCharacters(Refused(word, given)), 80U) << Refused(word, given);
    }
    PageCommand command{word};
    command.value = 1;
    command.h_form = long_one;
    EXPECT_LE(CountCharacters(say::PageNow(command)), 80U) << say::PageNow(command);
  }
}

TEST(PageWords, AreToldWithWhatTheyGive) {
  EXPECT_EQ(say::PageNow(Read(PageWord::kWidth, "120 %")), "Width 120 percent of the usual.");
  EXPECT_EQ(say::PageNow(Read(PageWord::kTilt, "10")), "Page tilted by 10 degrees.");
  EXPECT_EQ(say::PageNow(Read(PageWord::kPaper, "grid")), "Paper grid.");
  EXPECT_EQ(say::PageNow(Read(PageWord::kForm, "arc")), "H has the form arc.");
}

}  // namespace
}  // namespace moontrace
