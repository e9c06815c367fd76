#include "lessons/documents/brf_document.h"

#include <gtest/gtest.h>

#include "lessons/documents/braille_text.h"
#include "lessons/documents/open_document.h"
#include "lessons/documents/zip_archive.h"
#include "tests/lessons/documents/stored_book.h"
#include "textures/base/error.h"
#include "textures/base/utf8.h"
#include "textures/typeset/louis.h"

namespace moontrace {
namespace {

bool CanReadBraille() {
  try {
    BrailleTable table("en-ueb-g2.ctb");
    return true;
  } catch (const LackError&) {
    return false;
  }
}

/// By liblouis' lou_translate --forward en-us-brf.dis,en-ueb-g2.ctb, lines broken at 40 cells.
constexpr const char* kBook =
    "              ,! ,LI<TH\\SE\r\n"
    "\r\n"
    "  ,E TIDE HAS XS \"T1 & EA* %IP T GOES \\\r\n"
    "2F ! MORN+ \"KS X4 ,! KEEP] C.T$ #AB\r\n"
    "LAMPS4\r\n"
    "  ,HE WD N H D\"O T )\\T ! O!RS4\r\n"
    "\f\x1a";

TEST(BrfDocument, HasTheCellsOfNorthAmericanAsciiBraille) {
  // dots 1; 2; 12; 6; 3456; 4; all; 156; and small letters are the same cells
  EXPECT_EQ(ReadBrf("A1B,#@=:", "x").blocks.at(0).text, "⠁⠂⠃⠠⠼⠈⠿⠱");
  EXPECT_EQ(ReadBrf("az`{|}~", "x").blocks.at(0).text, ReadBrf("AZ@[\\]^", "x").blocks.at(0).text);
  const Document bad = ReadBrf("A\x7f\xe9", "x");
  EXPECT_EQ(bad.blocks.at(0).text, "⠁\xEF\xBF\xBD\xEF\xBF\xBD");
  ASSERT_EQ(bad.left_out.size(), 1U);
  EXPECT_EQ(bad.left_out[0].count, 2U);
}

TEST(BrfDocument, JoinsLinesAndTellsHeadings) {
  const Document book = ReadBrf(kBook, "x");
  ASSERT_EQ(book.blocks.size(), 3U);
  EXPECT_EQ(book.blocks[0].kind, BlockKind::kHeading);
  EXPECT_EQ(book.blocks[1].kind, BlockKind::kParagraph);
  EXPECT_EQ(book.blocks[2].kind, BlockKind::kParagraph);
  EXPECT_TRUE(IsBraille(book));
  Document print;
  print.blocks.push_back({});
  print.blocks[0].text = "the sign ⠁ is a";
  EXPECT_FALSE(IsBraille(print));
}

/// The text of blocks, by the cells' characters.
std::vector<std::string> CellsOf(const Document& document) {
  std::vector<std::string> texts;
  for (const Block& block : document.blocks) {
    std::string cells;
    for (const char32_t c : ToCodePoints(block.text)) {
      static constexpr std::string_view kLetters =
          " A1B'K2L@CIF/MSP\"E3H9O6R^DJG>NTQ,*5<-U8V.%[$+X!&;:4\\0Z7(_?W]#Y)=";
      cells += c == U' ' ? ' ' : kLetters.at(c - 0x2800);
    }
    texts.push_back(cells);
  }
  return texts;
}

/// A line of 40 cells, a number at its right margin.
std::string Numbered(const std::string& text, const std::string& number) {
  return text + std::string(40 - text.size() - number.size(), ' ') + number + "\r\n";
}

// BANA, Braille Formats 2016, 1.6, 1.11 and 1.12: a running head and a number at the right of the
// first or the last line of each sheet; a line of hyphens where a print page begins.
TEST(BrfDocument, NumbersAndHeadsOfSheetsAreNoText) {
  const std::string head = "              TIDES";
  const Document book =
      ReadBrf(Numbered("", "#I") + "  HE WENT UP\r\nAND\r\nUP\r\n\f" + Numbered(head, "#AJ") +
                  "AND DOWN\r\nTHE\r\nSTAIR\r\n\f" + Numbered(head, "#AA") + "AND UP\r\n" +
                  Numbered(std::string(37, '-'), "#AB") + "AGAIN\r\n\f",
              "x");
  ASSERT_EQ(book.blocks.size(), 1U);
  EXPECT_EQ(CellsOf(book).front(), "HE WENT UP AND UP AND DOWN THE STAIR AND UP AGAIN");
  ASSERT_EQ(book.blocks[0].marks.size(), 1U);
  EXPECT_EQ(book.blocks[0].marks[0].kind, MarkKind::kPrintPage);
  EXPECT_EQ(book.blocks[0].marks[0].value, "12");
}

TEST(BrfDocument, ABottomLineKeepsItsTextBesideTheNumber) {
  const std::string first = "  SIX SHIPS\n" + Numbered("LAY SIX DAYS IN THE HAR-", "#A") + "\f";
  const Document book = ReadBrf(first + "BOUR OF THE TOWN\n" + Numbered("AND LEFT", "#B"), "x");
  EXPECT_EQ(CellsOf(book), std::vector<std::string>{
                               "SIX SHIPS LAY SIX DAYS IN THE HAR-BOUR OF THE TOWN AND LEFT"});
  const Document prices = ReadBrf(Numbered("TEA", "#D") + "\f" + Numbered("OIL", "#A"), "x");
  EXPECT_NE(CellsOf(prices).front().find("#D"), std::string::npos) << "counts no sheets";
}

// A new part begins on a new sheet, though its first line is not set in.
TEST(BrfDocument, ASheetThatIsNotFullEndsItsParagraph) {
  EXPECT_EQ(CellsOf(ReadBrf("A\nB\nC\n\fD\n\fE\nF\nG\n", "x")),
            (std::vector<std::string>{"A B C D", "E F G"}));
}

TEST(BrailleText, IsReadAsPrintWithItsMarks) {
  if (!CanReadBraille()) GTEST_SKIP() << "built without liblouis";
  Document book = ReadBrf(kBook, "x");
  book.blocks[2].marks.push_back({MarkKind::kLink, 0, std::string("⠠⠓⠑").size(), "#x"});
  ReadPatterns(book, BrailleTableFor("en-GB"));
  EXPECT_EQ(book.blocks[0].text, "The Lighthouse");
  EXPECT_EQ(book.blocks[1].text,
            "Every tide has its time, and each ship that goes out before the morning knows it. "
            "The keeper counted 12 lamps.");
  EXPECT_EQ(book.blocks[2].text, "He would not have done that without the others.");
  const DocumentMark& mark = book.blocks[2].marks[0];
  EXPECT_EQ(book.blocks[2].text.substr(mark.begin, mark.end - mark.begin), "He");
}

TEST(BrailleText, KeepsWhatATableDoesNotRead) {
  if (!CanReadBraille()) GTEST_SKIP() << "built without liblouis";
  Document book;
  book.blocks.push_back({});
  book.blocks[0].text = "print ⠁ \xEF\xBF\xBD ⠿⠿⠿⠿ ⢿ ⠃";
  ReadPatterns(book, "en-ueb-g2.ctb");
  const std::string& text = book.blocks[0].text;
  EXPECT_EQ(text.rfind("print a \xEF\xBF\xBD ", 0), 0U) << text;
  EXPECT_NE(text.find("⢿"), std::string::npos) << text;  // eight dots are no sign of this table
  EXPECT_THROW(ReadPatterns(book, "none-such.ctb"), InputError);
}

TEST(BrailleText, IsOfTheBooksLanguage) {
  EXPECT_EQ(BrailleTableFor("de-AT"), "de-g2.ctb");
  EXPECT_EQ(BrailleTableFor("en"), "en-ueb-g2.ctb");
  EXPECT_EQ(BrailleTableFor(""), "en-ueb-g2.ctb");
}

/// eBraille 1.0: a package at the root without a container, chapters of Unicode's patterns.
TEST(EBraille, IsABookWithoutAContainer) {
  if (!CanReadZip()) GTEST_SKIP() << "built without libzip";
  const std::string zip = StoredZip(
      {{"mimetype", "application/epub+zip"},
       {"package.opf",
        "<?xml version='1.0'?><package xmlns='http://www.idpf.org/2007/opf' version='3.0'>"
        "<metadata xmlns:dc='http://purl.org/dc/elements/1.1/'><dc:title>Tides</dc:title>"
        "<dc:format>eBraille 1.0</dc:format><dc:language>en</dc:language></metadata><manifest>"
        "<item id='c' href='ebraille/c.xhtml' media-type='application/xhtml+xml'/></manifest>"
        "<spine><itemref idref='c'/></spine></package>"},
       {"ebraille/c.xhtml",
        "<html xmlns='http://www.w3.org/1999/xhtml'><head><title>c</title></head><body>"
        "<h1>⠠⠮⠀⠎⠂</h1><p>⠠⠮ ⠞⠊⠙⠑⠲</p></body></html>"}});
  Document book = ReadDocument(zip, "a.ebrl", {});
  EXPECT_EQ(book.format, DocumentFormat::kEBraille);
  EXPECT_EQ(book.title, "Tides");
  ASSERT_EQ(book.blocks.size(), 2U);
  EXPECT_TRUE(IsBraille(book));
  if (!CanReadBraille()) GTEST_SKIP() << "built without liblouis";
  ReadPatterns(book, BrailleTableFor(book.language));
  EXPECT_EQ(book.blocks[1].text, "The tide.");
}

}  // namespace
}  // namespace moontrace
