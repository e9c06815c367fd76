#include "lessons/documents/document_places.h"

#include <gtest/gtest.h>

#include "lessons/documents/html_document.h"
#include "lessons/documents/html_tree.h"
#include "lessons/documents/text_document.h"

namespace moontrace {
namespace {

TEST(DocumentPlaces, TellBlockHeadingsAndSentence) {
  const Document document = ReadPlainText(
      "# Sea\n\n## Tides\n\nHigh water comes twice. It falls again! Then\nall rest.\n\n"
      "## Winds\n\nCalm.\n",
      "x", true);
  const Transcription text = Transcribe(document);
  const std::size_t at = text.text.find("falls");
  const std::vector<std::size_t> trail = HeadingTrail(document, BlockAt(text, at));
  ASSERT_EQ(trail.size(), 2U);
  EXPECT_EQ(document.blocks[trail[0]].text, "Sea");
  EXPECT_EQ(document.blocks[trail[1]].text, "Tides");
  EXPECT_EQ(SentenceAt(text.text, at), "It falls again!");
  EXPECT_EQ(SentenceAt(text.text, text.text.find("Calm")), "Calm.");
  EXPECT_EQ(SentenceAt(text.text, text.text.find("Winds")), "Winds");
  EXPECT_EQ(SentenceAt(text.text, 100000), "");
  const std::vector<std::size_t> last = HeadingTrail(document, document.blocks.size() - 1);
  ASSERT_EQ(last.size(), 2U);  // Tides is behind
  EXPECT_EQ(document.blocks[last[1]].text, "Winds");
  EXPECT_TRUE(HeadingTrail(Document{}, 0).empty());
}

TEST(DocumentPlaces, OfLinksAndPrintPagesAreThoseOfTheTranscription) {
  if (!CanReadHtml()) GTEST_SKIP() << "built without libgumbo";
  const Document document = ReadHtml(
      "<html><p>One<a epub:type='noteref' href='#n'>[1]</a> and <a href='http://x.y/'>far</a>"
      "<span epub:type='pagebreak' title='12'></span> on.</p><p id='n'>A note.</p></html>",
      "x");
  const Transcription text = Transcribe(document);
  ASSERT_EQ(text.links.size(), 2U);
  const TranscribedLink* note = LinkAt(text, text.text.find('1'));
  ASSERT_NE(note, nullptr);
  EXPECT_EQ(text.text.substr(note->begin, note->end - note->begin), "1");
  const DocumentMark& mark = document.blocks[note->block].marks[note->mark];
  ASSERT_NE(mark.target, kNoBlock);
  EXPECT_EQ(document.blocks[mark.target].text, "A note.");
  const TranscribedLink* far = LinkAt(text, text.text.find("far") + 2);
  ASSERT_NE(far, nullptr);
  EXPECT_EQ(document.blocks[far->block].marks[far->mark].target, kNoBlock);
  EXPECT_EQ(LinkAt(text, text.text.find("on.")), nullptr);
  EXPECT_EQ(LinkAt(text, 0), nullptr);
  EXPECT_EQ(PrintPageAt(text, text.text.find("far")), nullptr);
  ASSERT_NE(PrintPageAt(text, text.text.find("on.")), nullptr);
  EXPECT_EQ(PrintPageAt(text, text.text.find("on."))->name, "12");
}

TEST(DocumentPlaces, AreWordsWithoutMarks) {
  EXPECT_EQ(WordsOf("## A  heading\n> and [words](#x) of\n\\# it \\[1]"),
            "A heading and words of # it [1]");
  EXPECT_EQ(WordsOf("a [b] c"), "a [b] c");
  EXPECT_EQ(WordsOf(""), "");
}

std::string Numbered(int from, int to) {
  std::string text;
  for (int i = from; i < to; ++i) text += "sentence " + std::to_string(i) + " of a long book. ";
  return text;
}

TEST(FindAgain, LeadsToTheSameLetterAfterAnEdit) {
  const std::string text = Numbered(0, 500);
  const std::size_t byte = text.find("e 321") + 2;
  const Around around = AroundOf(text, byte);
  EXPECT_EQ(FindAgain(text, around, byte, text.size()), byte);
  // what stands before grows, shrinks, is another
  for (const std::string& changed :
       {Numbered(-300, 500), Numbered(200, 500), "x" + text, text.substr(0, text.size() - 999)}) {
    EXPECT_EQ(FindAgain(changed, around, byte, text.size()), changed.find("e 321") + 2);
  }
  // the words before it were written anew, or the words behind it
  std::string before = text;
  before.replace(byte - 30, 30, "something else altogether ");
  EXPECT_EQ(before.substr(FindAgain(before, around, byte, text.size()).value(), 5), "321 o");
  std::string behind = text;
  behind.replace(byte, 60, "is gone. ");
  EXPECT_EQ(behind.substr(FindAgain(behind, around, byte, text.size()).value(), 7), "is gone");
}

TEST(FindAgain, TakesTheNearestOfSeveralAndNeverLeavesTheText) {
  std::string text;
  for (int i = 0; i < 100; ++i) text += "the same words again. ";
  const std::size_t byte = 22 * 60 + 4;
  const Around around = AroundOf(text, byte);
  EXPECT_EQ(FindAgain(text, around, byte, text.size()), byte);
  EXPECT_EQ(FindAgain("", around, byte, text.size()), std::nullopt);
  EXPECT_EQ(FindAgain("x", {}, 5, 0), std::nullopt);
  EXPECT_EQ(SameShare("other", byte, text.size()), 3U);  // 60 percent
  EXPECT_EQ(SameShare("", 5, 9), 0U);
  EXPECT_EQ(SameShare("x", 5, 0), 0U);
}

TEST(FindAgain, TakesAFewWordsThatAreTheSameForNothing) {
  const std::string text = Numbered(0, 100);
  const std::size_t byte = text.find("e 50") + 2;
  const Around around = AroundOf(text, byte);
  EXPECT_EQ(FindAgain("Chapter 1 of a long book. And so on and on.", around, byte, text.size()),
            std::nullopt);
  // of a short text all that was kept must be there
  EXPECT_EQ(FindAgain("So it is so.", AroundOf("It is so.", 3), 3, 9), std::nullopt);
  EXPECT_EQ(FindAgain("Hm. It is so.", AroundOf("It is so.", 3), 3, 9), 7U);
}

TEST(Landmarks, TellAnEditFromABookThatBeginsAlike) {
  const std::string text = Numbered(0, 300);
  const std::string landmarks = LandmarksOf(text);
  EXPECT_LT(landmarks.size(), 600U);
  EXPECT_EQ(LandmarksIn(text, landmarks), 1);
  EXPECT_GT(LandmarksIn("A new paragraph.\n\n" + text.substr(200), landmarks), 0.9);
  const std::string front = text.substr(0, 1000);  // of a tenth
  EXPECT_LT(LandmarksIn(front + std::string(9000, 'x'), landmarks), 0.2);
  EXPECT_EQ(LandmarksIn("", landmarks), 0);
  EXPECT_EQ(LandmarksIn(text, ""), 0);
  EXPECT_EQ(LandmarksIn("It is so.", LandmarksOf("It is so.")), 1);
  EXPECT_EQ(LandmarksOf(""), "");
}

TEST(ReadAt, OfAListIsItsItemAndIsCutBetweenWords) {
  if (!CanReadHtml()) GTEST_SKIP() << "built without libgumbo";
  std::string html = "<html><ul>";
  for (int i = 0; i < 40; ++i) html += "<li>item number " + std::to_string(i) + "</li>";
  const Document document = ReadHtml(html + "</ul></html>", "x");
  const Transcription text = Transcribe(document);
  EXPECT_EQ(ReadAt(document, text, text.text.find("number 17")), "- item number 17");
  std::string words;
  for (int i = 0; i < 200; ++i) words += "word" + std::to_string(i) + " ";
  const std::string cut = SentenceAt(words, words.find("word100"));
  EXPECT_NE(words.find(" " + cut + " "), std::string::npos) << cut;
}

}  // namespace
}  // namespace moontrace
