// A reader by touch at the pages of a book: headings, quotations, paragraphs, line ends; and at the
// lines of a menu.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>

#include "lessons/documents/html_document.h"
#include "lessons/documents/html_tree.h"
#include "lessons/documents/transcribe.h"
#include "sim/book/book_messages.h"
#include "sim/physics/page_field.h"
#include "sim/reading/reading_run.h"
#include "sim/reading/reading_setup.h"
#include "sim/trial/trial.h"
#include "textures/base/random.h"
#include "textures/base/units.h"
#include "textures/fonts/script_library.h"
#include "textures/typeset/typeset.h"

namespace moontrace {
namespace {

/// From "Alice's Adventures in Wonderland" (Carroll 1865), and a verse of its sequel.
constexpr const char* kBook =
    "<h1>Alice</h1><h2>Down the Rabbit Hole</h2>"
    "<p>Alice was beginning to get very tired of sitting by her sister on the bank, and of having "
    "nothing to do. Once or twice she had peeped into the book her sister was reading, but it had "
    "no pictures or conversations in it, and what is the use of a book, thought Alice, without "
    "pictures or conversations?</p>"
    "<p>So she was considering in her own mind, as well as she could, for the hot day made her "
    "feel very sleepy and stupid, whether the pleasure of making a daisy chain would be worth the "
    "trouble of getting up and picking the daisies, when suddenly a white rabbit with pink eyes "
    "ran close by her.</p>"
    "<h2>The Pool of Tears</h2>"
    "<p>Curiouser and curiouser! cried Alice.</p>"
    "<blockquote><p>How doth the little crocodile improve his shining tail, and pour the waters of "
    "the Nile on every golden scale.</p></blockquote>"
    "<p>I am sure those are not the right words, said poor Alice, and her eyes filled with tears "
    "again as she went on.</p>"
    "<h2>The Walrus</h2>"
    "<p>The sun was shining on the sea, shining with all his might. He did his very best to make "
    "the billows smooth and bright. And this was odd, because it was the middle of the night.</p>";

struct Pages {
  std::size_t pages = 0;
  ReadingScore score;
};

/// The first ten pages of a text, as `recognise` has them read.
Pages ReadAll(const std::string& text, bool structure, double size = 0.012, double pitch = 0) {
  const Script script = FindScript("moon");
  TypeStyle style = DefaultStyle(size, Relief::kEngraved, script);
  style.structure.read = structure;
  if (pitch > 0) style.line_pitch = pitch;
  const Typeset set = SetText(text, script, style, {"custom", 0.17, 0.13, 0.01});
  const auto shapes = std::make_shared<SignShapes>(script, WrittenGlyphs(script));
  Pages read;
  for (; read.pages < std::min<std::size_t>(10, set.pages.size()); ++read.pages) {
    const TextPage& page = set.pages[read.pages];
    const TextureField field = PageField(page, script, style, false);
    ReadingSetup setup;
    setup.page = &page;
    setup.field = &field;
    setup.hand = ShippedHand();
    CompleteSetup(setup, shapes, script, style, 1 + read.pages);
    const ReadingResult result = RunReading(setup);
    EXPECT_TRUE(result.ended) << "page " << read.pages + 1;
    read.score += Compare(MarksOf(page, script), MarksOf(result.tokens, script));
  }
  return read;
}

void Tell(const char* what, const Pages& read) {
  const ReadingScore& score = read.score;
  std::printf("%s: %zu pages, %zu of %zu signs right; %zu wrong, %zu missed, %zu extra of all\n",
              what, read.pages, score.signs_right, score.signs, score.wrong, score.missed,
              score.extra);
}

/// What was not read as it stood, of all that stood there.
double Errors(const Pages& read) {
  const ReadingScore& score = read.score;
  return static_cast<double>(score.wrong + score.missed + score.extra) /
         static_cast<double>(score.right + score.wrong + score.missed);
}

// As accurate as the same words on plain pages; half a percent is one or two of what stands there.
TEST(SlowBookReading, TenPagesOfABookAreReadAsPlainOnesAre) {
  if (!CanReadHtml()) GTEST_SKIP() << "built without libgumbo";
  const Document document = ReadHtml(kBook, "book");
  std::string plain;
  for (const Block& block : document.blocks) plain += block.text + " ";
  const Pages book = ReadAll(Transcribe(document).text, true);
  Tell("book", book);
  const Pages flat = ReadAll(plain, false);
  Tell("plain", flat);
  EXPECT_EQ(book.pages, 10U);
  EXPECT_LE(Errors(book), Errors(flat) + 0.005);
}

// A line close below a heading is nearer than one of its large letters is high.
TEST(SlowBookReading, LinesCloseBelowHeadingsAreRead) {
  const Pages read = ReadAll(
      "we go home and it is late\n# at sea and so\nthe ship is old and so are we\n"
      "# go on and on\nso it is late and we go home\n# all at sea\nand so we are\n",
      true, 0.006, 0.0072);
  Tell("close lines", read);
  EXPECT_LT(read.score.missed, 2U) << "no word of two letters is left out, let alone a line";
}

TEST(SlowBookReading, TheLinesOfTheMenuAreRead) {
  std::string words;
  for (const std::string& word : say::MoonMenu()) words += word + "\n";
  const Pages menu = ReadAll(words, false);
  Tell("menu", menu);
  EXPECT_LE(Errors(menu), 0.01);
}

}  // namespace
}  // namespace moontrace
