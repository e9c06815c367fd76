#include "lessons/documents/epub_document.h"

#include <gtest/gtest.h>

#include "lessons/documents/html_tree.h"
#include "lessons/documents/open_document.h"
#include "lessons/documents/transcribe.h"
#include "tests/lessons/documents/document_file.h"
#include "tests/lessons/documents/stored_book.h"
#include "tests/source_path.h"

namespace moontrace {
namespace {

class EpubDocument : public testing::Test {
 protected:
  void SetUp() override {
    if (!CanReadZip()) GTEST_SKIP() << "built without libzip";
  }
  static Document Read(const ZipEntries& entries) {
    return ReadDocument(StoredZip(entries), "book.epub", {});
  }
  static std::string TextOf(const ZipEntries& entries) { return Transcribe(Read(entries)).text; }
  static std::string Refused(const ZipEntries& entries) {
    return RefusalOf([&] { Read(entries); });
  }
};

ZipEntries Replaced(ZipEntries entries, const std::string& name, const std::string& bytes) {
  std::erase_if(entries, [&](const auto& entry) { return entry.first == name; });
  if (!bytes.empty()) entries.emplace_back(name, bytes);
  return entries;
}

// Both by pandoc 2.17 from one text: a heading, a note, lists, a table, pictures, verse, code.
TEST_F(EpubDocument, BooksOfBothVersionsHoldTheSame) {
  for (const char* name : {"lighthouse-2.epub", "lighthouse-3.epub"}) {
    const Document book = OpenDocument(SourcePath("tests/data/documents/" + std::string(name)), {});
    EXPECT_EQ(book.title, "The Lighthouse");
    EXPECT_EQ(book.authors, (std::vector<std::string>{"Ann Keeper", "Bo Rock"}));
    EXPECT_EQ(book.language, "en-GB");
    const std::string text = Transcribe(book).text;
    for (const char* line :
         {"# First light\n", "> A quoted line.\n", "list of 3 items\n- lamp\n- oil\n",
          "table of 2 rows and 3 columns: People of the light; columns Name, Age, City\n",
          "row 2, Age: 41\n", "(picture without description)\n", "10\xC2\xB2 H\xE2\x82\x82O.",
          "The sea is calm to-night.\nThe tide is full,\n", "code # not a heading\n\\> x\n",
          "\n\\# not a heading \\[x](y is not a link\n", "1. The number is from 1882."}) {
      EXPECT_NE(text.find(line), std::string::npos) << name << "\n" << line << text;
    }
    const std::vector<ContentsEntry> contents = ContentsOf(book);
    ASSERT_GE(contents.size(), 2U);
    EXPECT_EQ(contents.back().title, "Tools");
    EXPECT_EQ(contents.back().level, 2);
    EXPECT_EQ(book.blocks[contents.back().block].text, "Tools");
  }
}

TEST_F(EpubDocument, EmptyTitlesEntitiesAndCharactersAreRead) {
  EXPECT_EQ(TextOf(Book({Chapter("<p>a&#x41;&amp;nbsp;<![CDATA[<b>]]></p>")})), "aA&nbsp;<b>\n");
  const Document declared =
      Read(Book({Chapter("<p>&a; &b; &x;</p>",
                         "<!DOCTYPE html [<!ENTITY a 'lo&#108;'><!ENTITY b '&a;&a;'><!ENTITY x "
                         "SYSTEM 'file:///etc/passwd'>]>")}));
  EXPECT_EQ(Transcribe(declared).text, "lol &b; &x;\n");
  EXPECT_EQ(CountOf(declared, LeftOut::kUnknownEntity), 2U);
  if (!CanReadHtml()) GTEST_SKIP() << "built without libgumbo";
  EXPECT_EQ(TextOf(Book({Chapter("<p>a&nbsp;b&mdash;c &nosuch;</p>")})),
            "a\xC2\xA0"
            "b\xE2\x80\x94"
            "c &nosuch;\n");
}

TEST_F(EpubDocument, ChaptersComeInTheOrderOfTheSpine) {
  ZipEntries book = Book({Chapter("<p>one</p>"), Chapter("<p>two</p>"), Chapter("<p>three</p>")});
  const std::string manifest =
      "<item id='a' href='c0.xhtml' media-type='application/xhtml+xml'/>"
      "<item id='b' href='./c1.xhtml' media-type='application/xhtml+xml'/>"
      "<item id='c' href='x/../c%32.xhtml' media-type='application/xhtml+xml'/>";
  book = Replaced(book, "OPS/book.opf",
                  Package(manifest,
                          "<itemref idref='c' linear='no'/><itemref idref='b'/>"
                          "<itemref idref='a'/>"));
  const Document read = Read(book);
  EXPECT_EQ(Transcribe(read).text, "two\n\none\n\nthree\n");
  EXPECT_EQ(read.title, "Sea & Land");
  EXPECT_EQ(CountOf(read, LeftOut::kLaterPart), 1U);
}

TEST_F(EpubDocument, OddChaptersAreFoundOrToldOf) {
  const std::string manifest =
      "<item id='typed' href='c0.xhtml' media-type='application/octet-stream'/>"
      "<item id='data' href='d.json' media-type='application/json' fallback='c1'/>"
      "<item id='c1' href='c1.xhtml' media-type='application/xhtml+xml'/>"
      "<item id='picture' href='p.jpg' media-type='image/jpeg'/>"
      "<item id='gone' href='gone.xhtml' media-type='application/xhtml+xml'/>"
      "<item id='out' href='../../etc/passwd' media-type='application/xhtml+xml'/>"
      "<item id='file' href='file:///etc/passwd' media-type='application/xhtml+xml'/>"
      "<item id='web' href='http://example.org/x' media-type='application/xhtml+xml'/>";
  std::string spine;
  for (const char* id : {"typed", "data", "picture", "gone", "out", "file", "web", "unknown"}) {
    spine += "<itemref idref='" + std::string(id) + "'/>";
  }
  ZipEntries book = Book({Chapter("<p>wrong type</p>"), Chapter("<p>stands in</p>")});
  book = Replaced(book, "OPS/book.opf", Package(manifest, spine));
  book.emplace_back("OPS/p.jpg", "\xFF\xD8 no text");
  book.emplace_back("OPS/d.json", "{}");
  book.emplace_back("../../etc/passwd", Chapter("<p>outside</p>"));
  const Document read = Read(book);
  EXPECT_EQ(Transcribe(read).text, "wrong type\n\nstands in\n");
  EXPECT_EQ(CountOf(read, LeftOut::kUnreadablePart), 1U);
  EXPECT_EQ(CountOf(read, LeftOut::kMissingPart), 3U) << "gone, out, unknown";
  EXPECT_EQ(CountOf(read, LeftOut::kOutsidePart), 2U);
}

TEST_F(EpubDocument, BothTablesOfContentsAndPagesLead) {
  ZipEntries book = Book({Chapter("<h1 id='h'>One</h1><p>a<i id='p2'/>b</p>")});
  const std::string chapter = "<item id='c0' href='c0.xhtml' media-type='application/xhtml+xml'/>";
  book.emplace_back(
      "OPS/nav.xhtml",
      Chapter("<nav epub:type='toc'><ol><li><a href='c0.xhtml#h'>Part <img alt='I'/></a>"
              "<ol><li><a href='gone.xhtml'>Gone</a></li></ol></li></ol></nav>"
              "<nav epub:type='page-list'><ol><li><a href='c0.xhtml#p2'>2</a></li></ol>"
              "</nav>"));
  book.emplace_back(
      "OPS/toc.ncx",
      "<ncx><navMap><navPoint><navLabel><text>Older</text></navLabel><content src='c0.xhtml'/>"
      "</navPoint></navMap></ncx>");
  const std::string ncx = "<item id='n' href='toc.ncx' media-type='application/x-dtbncx+xml'/>";
  const std::string nav =
      "<item id='v' href='nav.xhtml' properties='nav' media-type='application/xhtml+xml'/>";
  const auto with = [&](const std::string& items) {
    return Replaced(book, "OPS/book.opf",
                    Package(chapter + items, "<itemref idref='c0'/>", " toc='n'"));
  };
  const Document newer = Read(with(ncx + nav));
  ASSERT_EQ(newer.contents.size(), 2U);
  EXPECT_EQ(newer.contents[0].title, "Part I");
  EXPECT_EQ(newer.contents[0].block, 0U);
  EXPECT_EQ(newer.contents[1].level, 2);
  EXPECT_EQ(newer.contents[1].block, kNoBlock);
  EXPECT_EQ(newer.blocks[1].marks, (std::vector<DocumentMark>{{MarkKind::kPrintPage, 1, 1, "2"}}));
  EXPECT_EQ(Read(with(ncx)).contents.at(0).title, "Older");
  // A navigation document that is not well-formed must not be shown (EPUB 3.3 reading systems).
  const Document broken = Read(Replaced(with(nav), "OPS/nav.xhtml", "<html><nav>"));
  EXPECT_EQ(CountOf(broken, LeftOut::kBrokenContents), 1U);
  EXPECT_EQ(ContentsOf(broken).at(0).title, "One") << "its headings";
}

TEST_F(EpubDocument, PathsMayStartAtTheRootAndAreDecodedOnce) {
  ZipEntries book = {
      {"mimetype", "application/epub+zip"},
      {"META-INF/container.xml",
       "<container><rootfiles><rootfile full-path='/OPS/the%20book.opf' "
       "media-type='application/xml'/></rootfiles></container>"},
      {"OPS/the book.opf",
       Package("<item id='a' href='/OPS/a%2520b.xhtml' media-type='application/xhtml+xml'/>"
               "<item id='b' href='c%20d.xhtml' media-type='application/xhtml+xml'/>",
               "<itemref idref='a'/><itemref idref='b'/>")},
      {"OPS/a%20b.xhtml", Chapter("<p>first <a href='c%20d.xhtml#n%201'>on</a></p>")},
      {"OPS/c d.xhtml", Chapter("<p>one</p><p id='n 1'>second</p>")},
      {"OPS/a b.xhtml", Chapter("<p>decoded twice</p>")}};
  const Document read = Read(book);
  EXPECT_EQ(read.blocks.at(0).text, "first on");
  EXPECT_EQ(read.blocks[0].marks.at(0).target, 2U);
  EXPECT_TRUE(read.left_out.empty());
}

// EPUB reading systems 3.3, 4.1.1: ".." of the archive's root is the root.
TEST_F(EpubDocument, NoPathClimbsAboveTheRoot) {
  ZipEntries book = Book({Chapter("<p>first <a href='../../../up/last.xhtml'>on</a></p>")});
  const std::string type = "media-type='application/xhtml+xml'";
  book = Replaced(book, "OPS/book.opf",
                  Package("<item id='a' href='../../OPS/c0.xhtml' " + type +
                              "/><item id='b' href='/../up/last.xhtml' " + type + "/>",
                          "<itemref idref='a'/><itemref idref='b'/>"));
  book.emplace_back("up/last.xhtml", Chapter("<p>last</p>"));
  const Document read = Read(book);
  EXPECT_EQ(read.blocks.at(0).text, "first on");
  EXPECT_EQ(read.blocks[0].marks.at(0).target, 1U);
  EXPECT_EQ(read.blocks.at(1).text, "last");
  EXPECT_TRUE(read.left_out.empty());
}

// It led to the beginning of its chapter, as if that were it.
TEST_F(EpubDocument, ALinkWhoseTargetIsMissingLeadsNowhere) {
  const Document read =
      Read(Book({Chapter("<p><a href='c1.xhtml#nosuch'>a</a> <a href='c1.xhtml'>b</a> "
                         "<a href='c7.xhtml'>c</a> <a href='http://x.y/'>d</a></p>"),
                 Chapter("<p>next</p>")}));
  const std::vector<DocumentMark>& marks = read.blocks.at(0).marks;
  ASSERT_EQ(marks.size(), 4U);
  EXPECT_TRUE(marks[0].missing) << "a place that is not marked";
  EXPECT_EQ(marks[0].target, kNoBlock);
  EXPECT_FALSE(marks[1].missing);
  EXPECT_EQ(marks[1].target, 1U);
  EXPECT_TRUE(marks[2].missing) << "a chapter that is not there";
  EXPECT_FALSE(marks[3].missing) << "it leads out";
  EXPECT_EQ(marks[3].target, kNoBlock);
}

// It was refused as a book without chapters.
TEST_F(EpubDocument, WithoutAnOrderThePagesAreReadAsTheyAreListed) {
  const std::string type = "media-type='application/xhtml+xml'";
  ZipEntries book = Book({Chapter("<p>first</p>"), Chapter("<p>second</p>")});
  book = Replaced(book, "OPS/book.opf",
                  Package("<item id='n' href='nav.xhtml' properties='nav' " + type +
                              "/><item id='b' href='c1.xhtml' " + type +
                              "/><item id='s' href='s.css' media-type='text/css'/>"
                              "<item id='a' href='c0.xhtml' " +
                              type + "/>",
                          ""));
  book.emplace_back("OPS/nav.xhtml", Chapter("<nav epub:type='toc'><ol><li><a "
                                             "href='c0.xhtml'>One</a></li></ol></nav>"));
  book.emplace_back("OPS/s.css", "p {}");
  const Document read = Read(book);
  EXPECT_EQ(Transcribe(read).text, "second\n\nfirst\n");
  ASSERT_EQ(read.contents.size(), 1U);
  EXPECT_EQ(read.contents[0].block, 1U);
  EXPECT_EQ(CountOf(read, LeftOut::kLaterPart), 2U) << "which is told";
}

TEST_F(EpubDocument, UnusualPackingIsRefusedInWords) {
  const std::string zip = StoredZip(Book({Chapter("<p>x</p>")}));
  std::string bzip2 = zip;  // method 12 of the last entry, in the directory and before its bytes
  bzip2[bzip2.rfind("PK\x01\x02") + 10] = 12;
  bzip2[bzip2.rfind("PK\x03\x04") + 8] = 12;
  EXPECT_EQ(RefusalOf([&] { ReadDocument(bzip2, "b", {}); }),
            "b: is packed in a way that no book is (OPS/book.opf in it, method 12); unpack it and "
            "pack it again as zip with deflate");
  std::string parts = zip;  // the second of two disks
  parts[parts.rfind("PK\x05\x06") + 4] = 1;
  EXPECT_NE(RefusalOf([&] { ReadDocument(parts, "b", {}); }).find("damaged zip"),
            std::string::npos);
  EXPECT_EQ(RefusalOf([&] { ReadDocument("PK\x07\x08" + zip.substr(0, 400), "b", {}); }),
            "b: is a piece of a split zip archive; save it as EPUB, HTML or plain text")
      << "the first disk of two";
}

// EPUB reading systems 3.3, 5.2: where scripts are not run, the fallback is read.
TEST_F(EpubDocument, WhatStandsInForAScriptIsRead) {
  ZipEntries book = Book({Chapter("<p>scripted</p>"), Chapter("<p>stands in</p>"),
                          Chapter("<p>scripted, alone; <a href='c0.xhtml'>back</a></p>")});
  const std::string type = "media-type='application/xhtml+xml'";
  book = Replaced(book, "OPS/book.opf",
                  Package("<item id='a' href='c0.xhtml' properties='scripted' fallback='b' " +
                              type + "/><item id='b' href='c1.xhtml' " + type +
                              "/><item id='c' href='c2.xhtml' properties='scripted' " + type + "/>",
                          "<itemref idref='a'/><itemref idref='c'/>"));
  const Document read = Read(book);
  EXPECT_EQ(read.blocks.at(0).text, "stands in");
  EXPECT_EQ(read.blocks.at(1).text, "scripted, alone; back");
  EXPECT_EQ(read.blocks[1].marks.at(0).target, 0U);
  EXPECT_EQ(CountOf(read, LeftOut::kStandIn), 1U);
}

TEST_F(EpubDocument, APageWithinAPageIsReadInItsPlace) {
  const auto of = [](const std::string& body) {
    ZipEntries book = Book({Chapter("<p>before</p>" + body + "<p>after</p>")});
    const std::string type = "media-type='application/xhtml+xml'/>";
    book = Replaced(
        book, "OPS/book.opf",
        Package("<item id='a' href='c0.xhtml' " + type + "<item id='b' href='in/page.xhtml' " +
                    type + "<item id='c' href='sound.mp3' media-type='audio/mpeg'/>",
                "<itemref idref='a'/>"));
    book.emplace_back("OPS/in/page.xhtml",
                      Chapter("<h2 id='h'>within</h2><iframe src='page.xhtml'/><object "
                              "data='../c0.xhtml'/>"));
    book.emplace_back("OPS/unlisted.xhtml", Chapter("<p>unlisted</p>"));
    book.emplace_back("OPS/sound.mp3", "sound");
    return Read(book);
  };
  const Document framed =
      of("<iframe src='in/page.xhtml'>instead</iframe><p><a "
         "href='in/page.xhtml#h'>up</a></p>");
  EXPECT_EQ(Transcribe(framed).text, "before\n\n## within\n\n[up](in/page.xhtml#h)\n\nafter\n");
  EXPECT_EQ(framed.blocks.at(2).marks.at(0).target, 1U);
  EXPECT_EQ(CountOf(framed, LeftOut::kMedia), 2U) << "what the page within would hold";
  EXPECT_EQ(Transcribe(of("<object data='in/page.xhtml'>instead</object>")).text,
            "before\n\n## within\n\nafter\n");
  for (const char* address : {"sound.mp3", "unlisted.xhtml", "https://w3.org/", "file:///x", ""}) {
    const Document other = of("<object data='" + std::string(address) + "'>instead</object>");
    EXPECT_EQ(Transcribe(other).text, "before\n\ninstead\n\nafter\n") << address;
    EXPECT_EQ(CountOf(other, LeftOut::kMedia), 1U) << address;
  }
}

TEST_F(EpubDocument, PagesWithinPagesAreCountedAndBounded) {
  std::string frames;
  for (int i = 0; i < 1500; ++i) frames += "<iframe src='c1.xhtml'/>";
  const Document read = Read(Book({Chapter(frames), Chapter("<p>again</p>")}));
  EXPECT_EQ(read.blocks.size(), 1001U) << "and the chapter itself";
  EXPECT_EQ(CountOf(read, LeftOut::kMedia), 500U);
}

// EPUB content documents 3.0.1, 2.1.3.4: the first case that is known, else the default.
TEST_F(EpubDocument, OfASwitchOneChildIsRead) {
  const auto read = [](const std::string& cases) {
    return TextOf(Book({Chapter("<p>a <epub:switch>" + cases +
                                "<epub:default>none</epub:default></epub:switch> b</p>")}));
  };
  const std::string chemistry = "<epub:case required-namespace='urn:cml'>H2O</epub:case>";
  const std::string mathematics =
      "<epub:case required-namespace='http://www.w3.org/1998/Math/MathML'>"
      "<math xmlns='http://www.w3.org/1998/Math/MathML'><mi>x</mi></math></epub:case>";
  EXPECT_EQ(read(chemistry), "a none b\n");
  EXPECT_EQ(read(chemistry + mathematics + mathematics), "a x b\n");
  EXPECT_EQ(TextOf(Book({Chapter("<svg xmlns='http://www.w3.org/2000/svg'><switch>"
                                 "<text systemLanguage='fr'>mer</text><text systemLanguage='de, "
                                 "en-GB'>sea</text><text>?</text></switch></svg>")})),
            "(picture: sea)\n")
      << "the package says en";
}

TEST_F(EpubDocument, DrawingsAreReadByTheirWordsAndToldNotToBeLaidOut) {
  const Document read = Read(Book(
      {Chapter("<p>See <svg aria-label='A lamp'><title>A lamp</title><desc>It shines.</desc>"
               "<style>.a{}</style><g aria-label='mast'><path d='M0 0'/></g><text>oil</text>"
               "<text>wick</text></svg> and <svg><title>Tides</title><svg><text>high</text></svg>"
               "</svg>.</p><p><img src='map.svg' alt='A map'/><svg><path d='M0 0'/></svg></p>")}));
  EXPECT_EQ(read.blocks.at(0).text, "See A lamp It shines. mast oil wick and Tides high .");
  ASSERT_EQ(read.left_out.size(), 2U);
  EXPECT_EQ(CountOf(read, LeftOut::kPicture), 1U);
  EXPECT_EQ(CountOf(read, LeftOut::kDrawing), 3U);
  EXPECT_EQ(read.left_out[1].example, "A lamp");
}

TEST_F(EpubDocument, WordsOfADrawingAreReadByLineAndOnlyWhereTheyShow) {
  const Document read = Read(Book(
      {Chapter("<svg><text><tspan x='0'>The r</tspan><tspan x='9'>ed</tspan><tspan x='0' "
               "dy='1.2em'>lamp</tspan><tspan x='0' y='30'>shines</tspan></text><text "
               "display='none'>dark</text><g visibility='hidden'><text>night</text></g></svg>")}));
  EXPECT_EQ(read.blocks.at(0).text, "The red lamp shines");
  EXPECT_EQ(CountOf(read, LeftOut::kHiddenPart), 2U);
}

TEST_F(EpubDocument, FaultyNamesAreToldAndReadAllTheSame) {
  const auto fault = [](const std::string& body) -> std::string {
    const Document read = Read(Book({Chapter("<p>x</p>" + body + "<p>y</p>")}));
    EXPECT_EQ(read.blocks.back().text, "y");
    return read.left_out.empty() ? "" : read.left_out[0].example;
  };
  EXPECT_EQ(fault("<p xml:lang='en' epub:type='z'>k</p>"), "");
  EXPECT_EQ(fault("<b xmlns:m='urn:m'><m:i m:a='1'/></b>"), "");
  EXPECT_EQ(fault("<b xmlns:m='urn:m'/><m:i/>"), "undeclared prefix m");
  EXPECT_EQ(fault("<p ops:type='z'>k</p>"), "undeclared prefix ops");
  EXPECT_EQ(fault("<p id='a' id='b'>k</p>"), "attribute id twice");
  EXPECT_EQ(fault("<epub::p>k</epub::p>"), "name epub::p");
}

TEST_F(EpubDocument, LinesOfTheContentsAreReadAsTheChaptersAre) {
  const auto title = [](const std::string& words) -> std::string {
    ZipEntries book = Book({Chapter("<p>one</p>")});
    const std::string type = "media-type='application/xhtml+xml'/>";
    book = Replaced(book, "OPS/book.opf",
                    Package("<item id='a' href='c0.xhtml' " + type +
                                "<item id='n' properties='nav' href='nav.xhtml' " + type,
                            "<itemref idref='a'/>"));
    book.emplace_back("OPS/nav.xhtml", Chapter("<nav epub:type='toc'><ol><li><a href='c0.xhtml'>" +
                                               words + "</a></li></ol></nav>"));
    const Document read = Read(book);
    return read.contents.empty() ? "" : read.contents[0].title;
  };
  EXPECT_EQ(title("\n a <img alt='b' title='no'/> <img title='c'/>"), "a b c");
  EXPECT_EQ(title("<b>1</b> <i>The</i>\n<i>lamp</i>"), "1 The lamp");
  EXPECT_EQ(title("<math alttext='x squared'><msup><mi>x</mi><mn>2</mn></msup></math>"),
            "x squared");
  EXPECT_EQ(title("<svg aria-label='The lamp'><title>no</title></svg>"), "The lamp");
  EXPECT_EQ(title("<svg><title>Its title</title></svg>"), "Its title");
  EXPECT_EQ(title("&lt;b&gt; &amp;mdash; &#233; &nosuch;"), "<b> &mdash; \xC3\xA9 &nosuch;");
  if (!CanReadHtml()) GTEST_SKIP() << "built without libgumbo";
  EXPECT_EQ(title("a&mdash;b &LT; &AMP;"),
            "a\xE2\x80\x94"
            "b &LT; &AMP;");
}

// EPUB 3.3 of navigation documents: items of their lists have no numbers of themselves.
TEST_F(EpubDocument, ContentsThatAreReadAsAChapterHaveNoNumbers) {
  EXPECT_EQ(TextOf(Book({Chapter("<nav epub:type='toc'><ol><li><a href='c0.xhtml'>One</a><ol><li>"
                                 "<span>Half</span></li></ol></li></ol></nav><ol><li>x</li></ol>"
                                 "<nav><ol><li>y</li></ol></nav>")})),
            "list of 1 item\n- [One](c0.xhtml)\nlist of 1 item, level 2\n-- Half\n\nlist of 1 "
            "item\n1. x\n\n"
            "list of 1 item\n1. y\n");
}

TEST_F(EpubDocument, AGroupOfTheContentsLeadsWhereItsFirstLineDoes) {
  ZipEntries book = Book({Chapter("<p>one</p>"), Chapter("<p>two</p>")});
  book.emplace_back(
      "OPS/nav.xhtml",
      Chapter("<nav epub:type='toc'><ol><li><span>Part</span><ol><li><span>Half</span><ol><li>"
              "<a href='c1.xhtml'>Two</a></li></ol></li></ol></li><li><span>Empty</span></li>"
              "<li><a href='gone.xhtml'>Gone</a></li></ol></nav>"));
  const std::string type = "media-type='application/xhtml+xml'";
  book =
      Replaced(book, "OPS/book.opf",
               Package("<item id='a' href='c0.xhtml' " + type + "/><item id='b' href='c1.xhtml' " +
                           type + "/><item id='n' properties='nav' href='nav.xhtml' " + type + "/>",
                       "<itemref idref='a'/><itemref idref='b'/>"));
  const Document read = Read(book);
  ASSERT_EQ(read.contents.size(), 5U);
  EXPECT_EQ(read.contents[0].block, 1U);
  EXPECT_EQ(read.contents[1].block, 1U);
  EXPECT_TRUE(read.contents[0].group && read.contents[1].group && read.contents[3].group);
  EXPECT_EQ(read.contents[3].block, kNoBlock);
  EXPECT_FALSE(read.contents[4].group);
}

TEST_F(EpubDocument, PackageAndContentsAreDecodedOnceByTheirOwnEncoding) {
  const std::string declared = "<?xml version='1.0' encoding='ISO-8859-1'?>";
  ZipEntries book = Book({Chapter("<p>x</p>")});
  std::string package = Package(
      "<item id='c' href='c0.xhtml' media-type='application/xhtml+xml'/>"
      "<item id='n' href='toc.ncx' media-type='application/x-dtbncx+xml'/>",
      "<itemref idref='c'/>", " toc='n'");
  package.replace(package.find("Sea &amp;"), 9, "Caf\xE9 &amp;");
  book = Replaced(book, "OPS/book.opf", declared + package.substr(package.find("<package")));
  book.emplace_back("OPS/toc.ncx", declared +
                                       "<ncx><navMap><navPoint><navLabel><text>\xC9t\xE9</text>"
                                       "</navLabel><content src='c0.xhtml'/></navPoint></navMap>"
                                       "</ncx>");
  const Document read = Read(book);
  EXPECT_EQ(read.title, "Caf\xC3\xA9 & Land");
  EXPECT_EQ(read.contents.at(0).title, "\xC3\x89t\xC3\xA9");
}

TEST_F(EpubDocument, DamagedChaptersAreReadAsWebPages) {
  if (!CanReadHtml()) GTEST_SKIP() << "built without libgumbo";
  const Document read = Read(Book({Chapter("<p>un<b>closed</p><p>next")}));
  EXPECT_EQ(Transcribe(read).text, "unclosed\n\nnext\n");
  EXPECT_EQ(CountOf(read, LeftOut::kBrokenPart), 1U);
}

TEST_F(EpubDocument, EncryptedBooksAreRefusedInWordsFontsAreNot) {
  const auto encrypted = [](const std::string& method, const std::string& path) {
    ZipEntries book = Book({Chapter("<p>x</p>")});
    book.emplace_back(
        "META-INF/encryption.xml",
        "<encryption xmlns:enc='http://www.w3.org/2001/04/xmlenc#'><enc:EncryptedData>"
        "<enc:EncryptionMethod Algorithm='" +
            method +
            "'/><enc:CipherData>"
            "<enc:CipherReference URI='" +
            path +
            "'/></enc:CipherData>"
            "</enc:EncryptedData></encryption>");
    return book;
  };
  const std::string aes = "http://www.w3.org/2001/04/xmlenc#aes256-cbc";
  EXPECT_NE(Refused(encrypted(aes, "OPS/c0.xhtml")).find("is encrypted"), std::string::npos);
  EXPECT_EQ(CountOf(Read(encrypted(aes, "OPS/p.jpg")), LeftOut::kEncryptedPart), 1U);
  EXPECT_TRUE(Read(encrypted("http://www.idpf.org/2008/embedding", "OPS/f.otf")).left_out.empty());
}

TEST_F(EpubDocument, DamagedBooksAreRefusedInOneLine) {
  const ZipEntries book = Book({Chapter("<p>x</p>")});
  EXPECT_NE(Refused(Replaced(book, "META-INF/container.xml", "")).find("no EPUB book"),
            std::string::npos);
  EXPECT_NE(
      Refused(Replaced(book, "META-INF/container.xml", "<container/>")).find("names no package"),
      std::string::npos);
  EXPECT_NE(Refused(Replaced(book, "OPS/book.opf", "")).find("its package, is missing"),
            std::string::npos);
  EXPECT_NE(Refused(Replaced(book, "OPS/book.opf", "<package>")).find("no package of EPUB"),
            std::string::npos);
  EXPECT_NE(Refused(Replaced(book, "OPS/book.opf", Package("", ""))).find("without chapters"),
            std::string::npos);
  EXPECT_NE(Refused(Replaced(book, "OPS/c0.xhtml", "")).find("holds no text"), std::string::npos);
  const std::string zip = StoredZip(book);
  for (const std::size_t size : {zip.size() / 2, zip.size() - 1, std::size_t{30}}) {
    EXPECT_NE(RefusalOf([&] { ReadDocument(zip.substr(0, size), "b", {}); }).find("damaged zip"),
              std::string::npos);
  }
}

TEST_F(EpubDocument, ABookWithoutTextIsRefusedWithItsCause) {
  const auto refused = [](const std::string& manifest, const std::string& chapter) {
    ZipEntries book = Replaced(Book({Chapter(chapter)}), "OPS/book.opf",
                               Package(manifest, "<itemref idref='a'/>"));
    book.emplace_back("OPS/disk.dmg", "no text");
    book.emplace_back("OPS/map.psd", "nor this");
    return Refused(book);
  };
  EXPECT_EQ(refused("<item id='a' href='disk.dmg' media-type='application/octet-stream' "
                    "fallback='b'/><item id='b' href='map.psd' media-type='image/psd'/>",
                    ""),
            "book.epub: holds no text that can be read (OPS/disk.dmg in it is no text, and no text "
            "stands in for it); get another edition");
  const std::string type = "media-type='application/xhtml+xml'/>";
  EXPECT_NE(refused("<item id='a' href='gone.xhtml' " + type, "")
                .find("OPS/gone.xhtml in it is missing); get it again"),
            std::string::npos);
  EXPECT_NE(refused("<item id='a' href='https://w3.org/x' " + type, "").find("is elsewhere"),
            std::string::npos);
  const std::string chapter = "<item id='a' href='c0.xhtml' " + type;
  EXPECT_NE(refused(chapter, "<video src='a.mp4'/>").find("sound, video"), std::string::npos);
  EXPECT_NE(refused(chapter, "<p hidden=''>x</p>").find("text is hidden"), std::string::npos);
  EXPECT_NE(refused(chapter, "<p/>").find("be read; get it again"), std::string::npos);
}

TEST_F(EpubDocument, WhatUnpacksToTooMuchIsRefused) {
  const ZipEntries book = Book({Chapter("<p>" + std::string(3 << 20, 'a') + "</p>")});
  OpenOptions small;
  small.limits.most_bytes = std::size_t{4} << 20U;
  EXPECT_EQ(ReadDocument(StoredZip(book), "b", small).blocks.size(), 1U);
  // The same chapter over and over is a bomb too.
  const std::string manifest = "<item id='c' href='c0.xhtml' media-type='application/xhtml+xml'/>";
  std::string spine;
  for (int i = 0; i < 100; ++i) spine += "<itemref idref='c'/>";
  const std::string again = StoredZip(Replaced(book, "OPS/book.opf", Package(manifest, spine)));
  EXPECT_EQ(RefusalOf([&] { ReadDocument(again, "b", small); }),
            "b: unpacks to more than is taken, with OPS/c0.xhtml; raise --most-mb if you trust it");
}

TEST_F(EpubDocument, DeepChaptersKeepTheirText) {
  std::string open, close;
  for (int i = 0; i < 100'000; ++i) {
    open += "<div>";
    close += "</div>";
  }
  const Document read = Read(Book({Chapter(open + "deep" + close)}));
  EXPECT_EQ(Transcribe(read).text, "deep\n");
  EXPECT_GT(CountOf(read, LeftOut::kDeepElement), 90'000U);
}

// Books hide notes so that reading systems show them at their call (Apple Books Asset Guide,
// "Pop-up footnotes"); pandoc ends a note by an arrow.
TEST_F(EpubDocument, NotesAreReadThoughTheirBookHidesThem) {
  const Document book = Read(Book({Chapter(
      "<p>a<a epub:type='noteref' href='#n'>1</a></p>"
      "<aside epub:type='footnote' id='n' style='display:none'><p>One.</p></aside>"
      "<section role='doc-endnotes' hidden='hidden'><p role='doc-endnote'>Two. <a href='#r' "
      "role='doc-backlink'>\xE2\x86\xA9\xEF\xB8\x8E</a></p></section>")}));
  ASSERT_EQ(book.blocks.size(), 3U);
  EXPECT_EQ(book.blocks[1].text, "One.");
  EXPECT_EQ(book.blocks[0].marks.at(0).target, 1U);
  EXPECT_EQ(book.blocks[2].text, "Two.");
  EXPECT_TRUE(book.blocks[2].note);
  EXPECT_TRUE(book.left_out.empty());
}

}  // namespace
}  // namespace moontrace
