#include "lessons/documents/html_document.h"

#include <gtest/gtest.h>

#include <chrono>
#include <string>

#include "lessons/documents/html_tree.h"
#include "lessons/documents/open_document.h"
#include "lessons/documents/transcribe.h"
#include "tests/lessons/documents/document_file.h"
#include "tests/source_path.h"

namespace moontrace {
namespace {

class HtmlDocument : public testing::Test {
 protected:
  void SetUp() override {
    if (!CanReadHtml()) GTEST_SKIP() << "built without libgumbo";
  }
  static std::string TextOf(const std::string& html) {
    return Transcribe(ReadHtml(html, "page.html")).text;
  }
};

std::string Times(const std::string& text, int count) {
  std::string all;
  for (int i = 0; i < count; ++i) all += text;
  return all;
}

// Written by hand from the page as a screen reader gives it.
constexpr const char* kPage =
    "[To the text](#main)\n\n"
    "# Tides\n\n"
    "High water comes twice a\xC2\xA0"
    "day & is told in m.\n\n"
    "See the notes [1], [the board](https://example.org/a_%28b%29) and [the map](map.html).\n\n"
    "> Time and tide wait for no man.\n\n"
    "list of 2 items\n3. Look\n4. Wait\nlist of 1 item, level 2\n-- for the ebb\n\n"
    "list of 1 item\nNeap\n- the small tide\n\n"
    "table of 2 rows and 3 columns: Today; columns Port, High, Low\n"
    "North, High: 6:10\nNorth, Low: 12:20\nSouth, High: 6:40\n\n"
    "left side\n\nright side\n\n"
    "(picture: The harbour at ebb)(picture without description)\n\n"
    "  line one\n    line two # kept\n\n"
    "\\# not a heading\n\\> not a quotation\n\n"
    "E = m c\xC2\xB2, H\xE2\x82\x82O, 4th\n\n"
    "---\n\n"
    "Bonjour\n\n"
    "\xE6\x9D\xB1\n\n"
    "no video\n";

TEST_F(HtmlDocument, IsReadAsAScreenReaderGivesIt) {
  const Document page = OpenDocument(SourcePath("tests/data/documents/page.html"), {});
  EXPECT_EQ(Transcribe(page).text, kPage);
  EXPECT_EQ(page.title, "Tide tables of the harbour");
  EXPECT_EQ(page.authors, std::vector<std::string>{"Harbour Office"});
  EXPECT_EQ(page.language, "en");
}

TEST_F(HtmlDocument, TellsWhatWasLeftOut) {
  const Document page = OpenDocument(SourcePath("tests/data/documents/page.html"), {});
  EXPECT_EQ(CountOf(page, LeftOut::kHiddenPart), 3U);
  EXPECT_EQ(CountOf(page, LeftOut::kPicture), 1U);
  EXPECT_EQ(CountOf(page, LeftOut::kMedia), 1U);
  EXPECT_EQ(CountOf(page, LeftOut::kReading), 1U);
  EXPECT_EQ(page.left_out.size(), 4U);
}

TEST_F(HtmlDocument, KeepsLanguagesPicturesAndLinksAsMarks) {
  const Document page = OpenDocument(SourcePath("tests/data/documents/page.html"), {});
  std::vector<DocumentMark> marks;
  for (const Block& block : page.blocks) {
    marks.insert(marks.end(), block.marks.begin(), block.marks.end());
  }
  const auto has = [&marks](const DocumentMark& mark) {
    return std::find(marks.begin(), marks.end(), mark) != marks.end();
  };
  EXPECT_TRUE(has({MarkKind::kLanguage, 0, 7, "fr"}));
  EXPECT_TRUE(has({MarkKind::kPicture, 0, 18, "harbour.jpg"}));
  EXPECT_TRUE(has({MarkKind::kPicture, 18, 18, "boat.jpg"}));
  EXPECT_TRUE(has({MarkKind::kLink, 4, 17, "notes.html"}));
}

TEST_F(HtmlDocument, IsBuiltAsBrowsersBuildIt) {
  EXPECT_EQ(TextOf("<p>one<p>two<b>bold</p>&copy 2 &#x80;"),
            "one\n\ntwobold\n\n\xC2\xA9 2 \xE2\x82\xAC\n");
  EXPECT_EQ(TextOf("<p>a<br><br>b<br>c"), "a\n\nb\nc\n");
  EXPECT_EQ(TextOf("plain text &lt;b&gt;"), "plain text <b>\n");
}

TEST_F(HtmlDocument, TablesAreToldCellByCell) {
  EXPECT_EQ(TextOf("<table><tr><td>a<td>b<tr><td>c<td>d</table>"),
            "table of 2 rows and 2 columns\nrow 1, column 1: a\nrow 1, column 2: b\n"
            "row 2, column 1: c\nrow 2, column 2: d\n");
  // A cell over two rows pushes the next row's to the right (HTML, forming a table).
  EXPECT_EQ(TextOf("<table><tr><th>x<th>y<tr><td rowspan=2>a<td>b<tr><td>c</table>"),
            "table of 2 rows and 2 columns; columns x, y\nrow 1, x: a\nrow 1, y: b\nrow 2, x: a\n"
            "row 2, y: c\n");
  EXPECT_EQ(TextOf("<table><tr><td><h1>T</h1><td><p>x<table><tr><td>1<td>2</table></table>"),
            "# T\n\nx\n\ntable of 1 row and 2 columns\nrow 1, column 1: 1\nrow 1, column 2: 2\n");
  EXPECT_EQ(TextOf("<table><tr><th>only<th>heads</table>"),
            "table of 1 row and 2 columns\nrow 1, column 1: only\nrow 1, column 2: heads\n");
}

TEST_F(HtmlDocument, ACellOverRowsIsToldInEach) {
  EXPECT_EQ(TextOf("<table><tr><th>Name<th>Day<th>Price<tr><td rowspan=3>Pear<td>1<td rowspan=9>5"
                   "<tr><td>2<tr><td>3</table>"),
            "table of 3 rows and 3 columns; columns Name, Day, Price\n"
            "row 1, Name: Pear\nrow 1, Day: 1\nrow 1, Price: 5\n"
            "row 2, Name: Pear\nrow 2, Day: 2\nrow 2, Price: 5\n"
            "row 3, Name: Pear\nrow 3, Day: 3\nrow 3, Price: 5\n");
  // a name of rows names each; one of columns names them once
  EXPECT_EQ(TextOf("<table><tr><th rowspan=2>x<th colspan=2>y<tr><th>a<th>b"
                   "<tr><th rowspan=2>N<td>1<td>2<tr><td>3<td>4</table>"),
            "table of 2 rows and 3 columns; columns x, y a, y b\n"
            "N, y a: 1\nN, y b: 2\nN, y a: 3\nN, y b: 4\n");
  // a long text over very many rows would fill the memory
  const std::string many =
      TextOf("<table><tr><th>x<th>y<tr><td rowspan=20000>" + Times("long ", 1000) + "<td>1" +
             Times("<tr><td>1", 9999) + "</table>");
  EXPECT_LT(many.size(), 1000000U);
}

// HTML, 4.4.5: without a start it begins at the number of items.
TEST_F(HtmlDocument, AReversedListCountsDownFromTheNumberOfItsItems) {
  EXPECT_EQ(TextOf("<ol reversed><li>p<li><li>q<ol><li>in</ol><li>r</ol>"),
            "list of 4 items\n4. p\n2. q\nlist of 1 item, level 2\n1. in\n1. r\n")
      << "an empty item counts";
  EXPECT_EQ(TextOf("<ol reversed type=a><li>p<li>q</ol>"), "list of 2 items\nb. p\na. q\n");
  EXPECT_EQ(TextOf("<ol reversed start=9><li>p<li>q</ol>"), "list of 2 items\n9. p\n8. q\n");
  EXPECT_EQ(TextOf("<ol reversed><li>p<li value=7>q<li>r</ol>"),
            "list of 3 items\n3. p\n7. q\n6. r\n");
}

// As browsers show them (HTML, 4.4.5 and 15.3.8).
TEST_F(HtmlDocument, AnItemKeepsItsNumberWhateverItBeginsWith) {
  EXPECT_EQ(TextOf("<ol><li><ol><li>a<li>b</ol><li>c</ol>"),
            "list of 2 items\n1.\nlist of 2 items, level 2\n1. a\n2. b\n2. c\n");
  EXPECT_EQ(TextOf("<ol><li><h3>Step</h3><p>Do it.</ol>"),
            "list of 1 item\n\n### 1. Step\n\nDo it.\n");
  EXPECT_EQ(TextOf("<ol><li>x<li><pre>a\nb</pre></ol>"), "list of 2 items\n1. x\n\n2. a\nb\n");
  EXPECT_EQ(TextOf("<ol><li><table><tr><td>p<td>q</table></ol>"),
            "list of 1 item\n1.\n\ntable of 1 row and 2 columns\nrow 1, column 1: p\n"
            "row 1, column 2: q\n");
  EXPECT_EQ(TextOf("<ol><li><img src=a.png><li>x</ol>"),
            "list of 2 items\n1. (picture without description)\n2. x\n");
  EXPECT_EQ(TextOf("<ul><li><ul><li>a</ul></ul>"),
            "list of 1 item\nlist of 1 item, level 2\n-- a\n");
}

TEST_F(HtmlDocument, ListsAreNumberedAsTheirTypeHasIt) {
  EXPECT_EQ(TextOf("<ol type=i start=3><li>p<li>q</ol>"), "list of 2 items\niii. p\niv. q\n");
  EXPECT_EQ(TextOf("<ol type=I start=1994><li>p</ol>"), "list of 1 item\nMCMXCIV. p\n");
  EXPECT_EQ(TextOf("<ol type=A start=26><li>p<li>q</ol>"), "list of 2 items\nZ. p\nAA. q\n");
  EXPECT_EQ(TextOf("<ol style='list-style-type: lower-alpha'><li>p</ol>"),
            "list of 1 item\na. p\n");
  EXPECT_EQ(TextOf("<ol style='margin:0;list-style:none'><li>1) own</ol>"),
            "list of 1 item\n1) own\n");
  EXPECT_EQ(TextOf("<ol><li>p<li style='list-style-type:none'><ol><li>q</ol></ol>"),
            "list of 2 items\n1. p\nlist of 1 item, level 2\n1. q\n");
}

// As publishers write calls of notes: Calibre, O'Reilly, Word, Wikipedia.
TEST_F(HtmlDocument, SmallFiguresStayApartWhateverElementsAreAroundThem) {
  EXPECT_EQ(TextOf("<p>in 1945<sup><a href=#n>1</a></sup> <a href=#n><sup>12</sup></a>"),
            "in 1945[\xC2\xB9](#n) [\xC2\xB9\xC2\xB2](#n)\n");
  EXPECT_EQ(TextOf("<p>H<sub><i>2</i></sub>O, 10<sup><span><b>3</b></span></sup>, 4<sup>th</sup>"),
            "H\xE2\x82\x82O, 10\xC2\xB3, 4th\n");
  EXPECT_EQ(TextOf("<p>it<sup><a href=#n><span>[</span>1<span>]</span></a></sup>"),
            "it[[1](#n)]\n");
}

TEST_F(HtmlDocument, ALinkWhoseTargetIsMissingLeadsNowhere) {
  const Document page = ReadHtml(
      "<p><a href='#gone'>a</a> <a href='#'>b</a> <a href='#top'>c</a> <a href='other.html#q'>d</a>"
      "<p>next",
      "x");
  const std::vector<DocumentMark>& marks = page.blocks.at(0).marks;
  ASSERT_EQ(marks.size(), 4U);
  EXPECT_TRUE(marks[0].missing);
  EXPECT_EQ(marks[0].target, kNoBlock);
  EXPECT_EQ(marks[1].target, 0U);
  EXPECT_EQ(marks[2].target, 0U);
  EXPECT_FALSE(marks[3].missing) << "another file";
}

TEST_F(HtmlDocument, MathematicsIsItsText) {
  EXPECT_EQ(TextOf("<p><math><mfrac><mrow><mi>a</mi><mo>+</mo><mi>b</mi></mrow><mn>2</mn></mfrac>"
                   "<mo>=</mo><msup><mi>x</mi><mn>2</mn></msup></math>"),
            "(a+b)/2=x^2\n");
  EXPECT_EQ(TextOf("<p><math alttext='a over b'><mfrac><mi>a</mi><mi>b</mi></mfrac></math>"),
            "a over b\n");
  EXPECT_EQ(TextOf("<p><math><semantics><msqrt><mi>x</mi></msqrt><annotation>\\sqrt x"
                   "</annotation></semantics></math>"),
            "\xE2\x88\x9A(x)\n");
}

TEST_F(HtmlDocument, PrintPagesAreMarks) {
  const Document page = ReadHtml("<p>end<span role=doc-pagebreak aria-label=12></span>begin", "p");
  ASSERT_EQ(page.blocks.size(), 1U);
  EXPECT_EQ(page.blocks[0].text, "endbegin");
  EXPECT_EQ(page.blocks[0].marks, (std::vector<DocumentMark>{{MarkKind::kPrintPage, 3, 3, "12"}}));
}

TEST_F(HtmlDocument, DeepElementsKeepTheirText) {
  for (const char* open : {"<div>", "<b>", "<x>", "<svg><div>", "<table><tr><td>", "<ul><li>",
                           "<select><option>", "<blockquote>", "<a href=x>", "<x/>"}) {
    const Document page = ReadHtml(Times(open, 100'000) + "deep", "p");
    EXPECT_NE(Transcribe(page).text.find("deep"), std::string::npos) << open;
    EXPECT_GT(CountOf(page, LeftOut::kDeepElement), 90'000U) << open;
  }
}

TEST_F(HtmlDocument, FormattingDoesNotMultiply) {
  std::string html;
  for (int i = 0; i < 300; ++i) html += "<b id=" + std::to_string(i) + ">";
  const Document page = ReadHtml(html + Times("<p>x", 50'000), "p");
  EXPECT_EQ(page.blocks.size(), 50'000U);
}

TEST_F(HtmlDocument, TooManyElementsAreRefused) {
  const std::string line = RefusalOf([] { ReadHtml(Times("<i>", 2'000'001), "big.html"); });
  EXPECT_EQ(line, "big.html: holds more than 2000000 elements; split it");
}

TEST_F(HtmlDocument, ScriptsStayUnreadWhereverTheyEnd) {
  EXPECT_EQ(TextOf("<p>a<script>'<p>no</p>'</script>b<!-- <p>no --><style>p</style>c"), "abc\n");
  EXPECT_EQ(TextOf(Times("<div>", 1000) + "<script>no</script>yes"), "yes\n");
  EXPECT_EQ(TextOf("<?xml version='1.0'?><html><head><title/></head><body><p>x<b>y</p>z"),
            "xy\n\nz\n")
      << "not well-formed: an empty title is empty";
}

// MathML as converters write it: single signs in rows, signs that print does not show.
TEST_F(HtmlDocument, FormulasHaveTheSignsOfPrintOnly) {
  const auto read = [](const std::string& formula) { return TextOf("<p><math>" + formula); };
  EXPECT_EQ(read("<msup><mi>c</mi><mrow><mn>2</mn></mrow></msup>"), "c^2\n");
  EXPECT_EQ(read("<msup><mi>c</mi><mrow><mi>n</mi><mo>+</mo><mn>2</mn></mrow></msup>"),
            "c^(n+2)\n");
  EXPECT_EQ(read("<mn>2</mn><mo>&InvisibleTimes;</mo><mi>sin</mi><mo>&ApplyFunction;</mo><mi>x"),
            "2sin x\n");
  EXPECT_EQ(read("<msup><mi>f</mi><mo>&prime;</mo></msup>"), "f\xE2\x80\xB2\n");
  EXPECT_EQ(read("<mmultiscripts><mi>C</mi><mn>6</mn><none></none></mmultiscripts>"), "C_6\n");
  EXPECT_EQ(read("<mi>f</mi><mfenced><mi>a</mi><mi>b</mi></mfenced>"), "f(a, b)\n");
}

TEST_F(HtmlDocument, AFormulasSourceIsReadOnlyWhereItHasNothingElse) {
  EXPECT_EQ(TextOf("<p><math alttext='\\frac{a}{b}'><mfrac><mi>a</mi><mi>b</mi></mfrac></math>"),
            "a/b\n");
  EXPECT_EQ(TextOf("<p><math alttext='\\pi'></math>"), "\\pi\n");
  // as Wikipedia writes it
  EXPECT_EQ(TextOf("<p>so <span class='mwe-math-mathml-inline mwe-math-mathml-a11y' "
                   "style='display: none;'><math alttext='{\\displaystyle x}'><semantics><mi>x</mi>"
                   "<annotation>{\\displaystyle x}</annotation></semantics></math></span><img "
                   "src=x.svg aria-hidden=true alt='{\\displaystyle x}'> is"),
            "so x is\n");
}

TEST_F(HtmlDocument, SpacesThatOnlyMoveWordsAreNone) {
  EXPECT_EQ(TextOf("<p>a<p>&nbsp;<p>&nbsp; &emsp;<p>b"), "a\n\nb\n") << "empty lines of Word";
  EXPECT_EQ(TextOf("<p>1.<span>&nbsp;&nbsp; </span>first, one.&nbsp; Two 5&nbsp;m&nbsp;"),
            "1. first, one. Two 5\xC2\xA0m\n");
  EXPECT_EQ(TextOf("<p>\xE3\x80\x80\xE3\x80\x80\xE6\x9C\x88\xE3\x80\x80x"),
            "\xE6\x9C\x88\xE3\x80\x80x\n");
  EXPECT_EQ(TextOf("<pre>a&nbsp;&nbsp;b</pre>"),
            "a\xC2\xA0\xC2\xA0"
            "b\n");
}

// HTML, 13.2.6.4.7: what stands in them is text of older browsers.
TEST_F(HtmlDocument, WhatStandsInFramesIsNoText) {
  EXPECT_EQ(TextOf("<p>a<iframe src=x><p>Your browser</p></iframe>b<noembed><i>no</i></noembed>"),
            "ab\n");
  EXPECT_EQ(TextOf("<html><frameset><frame src=a.html><noframes><body><p>Go <a href=a.html>there"
                   "</a></body></noframes></frameset></html>"),
            "Go [there](a.html)\n");
}

// As Project Gutenberg and DAISY's books write verse: each line an element.
TEST_F(HtmlDocument, LinesOfAStanzaStandTogether) {
  EXPECT_EQ(TextOf("<div class=poetry><div class=stanza><div class='verse indent0'>Roses,</div>"
                   "<div class='verse indent2'>violets.</div></div><div class=stanza>"
                   "<div class='verse indent0'>Sugar,</div></div></div><p>End"),
            "Roses,\nviolets.\n\nSugar,\n\nEnd\n");
  EXPECT_EQ(TextOf("<blockquote class=poem><p class=line>a</p><p class=line>b</p></blockquote>"),
            "> a\n> b\n");
  EXPECT_EQ(TextOf("<div class=poem><p>a<br>b</p><p>c<br>d</p></div>"), "a\nb\n\nc\nd\n");
}

/// "name@words behind it" of each printed page.
std::vector<std::string> PagesOf(const std::string& html) {
  const Transcription written = Transcribe(ReadHtml(html, "page.html"));
  std::vector<std::string> pages;
  for (const TranscribedPage& page : written.pages) {
    pages.push_back(page.name + "@" + written.text.substr(page.begin, 5));
  }
  return pages;
}

// As Project Gutenberg's books have them, by hand and by ppgen, and as DAISY's have.
TEST_F(HtmlDocument, NumbersOfPrintedPagesAreNoText) {
  const std::string page =
      "<p>The quick <span class='pagenum'><a id='Page_12'></a>[Pg 12]</span>brown fox "
      "jum<span class=pagenum><a name='p13'>[13]</a></span>ped<span class=pageno id=Page_xiv>xiv"
      "</span> over <span class='pagenum' id='Page_15' title='15'> </span>it.<p>See <a "
      "href='#Page_12'>12</a>.<pagenum id=p16 page=normal>16</pagenum> End";
  EXPECT_EQ(TextOf(page), "The quick brown fox jumped over it.\n\nSee [12](#Page_12). End\n");
  EXPECT_EQ(PagesOf(page), (std::vector<std::string>{"12@brown", "13@ped o", "xiv@ over",
                                                     "15@it.\n\n", "16@ End\n"}));
  EXPECT_FALSE(ReadHtml(page, "x").blocks.at(1).marks.at(0).missing) << "indexes lead there";
  EXPECT_EQ(TextOf("<p>Tides <span class=pagenum>12</span><p><span class=pagenum id=a>old number"),
            "Tides 12\n\nold number\n");
  EXPECT_EQ(TextOf("<table><tr><td>Tides<td class=pagenum id=q>12</table>"),
            "table of 1 row and 2 columns\nrow 1, column 1: Tides\nrow 1, column 2: 12\n");
}

// Names as the Accessible Publishing Knowledge Base has them: "Page 12", " 12. ".
TEST_F(HtmlDocument, APrintedPageIsCalledByItsNumberAlone) {
  EXPECT_EQ(PagesOf("<p>a <span role=doc-pagebreak aria-label=' 12. '></span>b <span "
                    "role=doc-pagebreak aria-label='Page xvi'></span>c <span role=doc-pagebreak "
                    "title='A-3'></span>d <span role=doc-pagebreak>page 4</span>e"),
            (std::vector<std::string>{"12@b c d", "xvi@c d e", "A-3@d e\n", "4@e\n"}));
}

// XHTML 1.0, C.8: id and name of an anchor are the same. With 20000 of them, and as many links, a
// table of anchors that is made anew for each link would take minutes.
TEST_F(HtmlDocument, AnchorsThatAreNamedTwiceCostNoTime) {
  std::string html;
  for (int i = 0; i < 20000; ++i) {
    const std::string id = "a" + std::to_string(i);
    html += "<p><a id=" + id + " name=" + id + " href='#" + id + "'>x</a>";
  }
  const auto begin = std::chrono::steady_clock::now();
  const Document page = ReadHtml(html, "x");
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
  ASSERT_EQ(page.blocks.size(), 20000U);
  EXPECT_EQ(page.blocks[19999].marks.at(0).target, 19999U);
}

// As newspapers load pictures late: a script shows the first, browsers without one the second.
TEST_F(HtmlDocument, APictureAndItsStandInAreOne) {
  EXPECT_EQ(TextOf("<figure><img data-src=a.jpg alt='Fire'><noscript><img src=a.jpg alt='Fire'>"
                   "</noscript><figcaption>Hill</figcaption></figure><noscript>Text <img src=b.jpg "
                   "alt='Sea'></noscript>"),
            "(picture: Fire)\n\nHill\n\nText (picture: Sea)\n");
}

}  // namespace
}  // namespace moontrace
