#include "sim/book/book_walk.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <csignal>
#include <set>

#include "lessons/documents/text_document.h"
#include "sim/session/loop_messages.h"
#include "sim/session/turn_mark.h"
#include "tests/sim/book_fixture.h"
#include "textures/base/error.h"

namespace moontrace {
namespace {

using Lines = std::vector<std::string>;

TEST_F(BookWalkTest, TellsHeadingsAndThePrintedPageApartFromItsOwn) {
  Open(kTides);
  EXPECT_TRUE(begun_.empty());  // read for the first time
  Lines lines = Say("where", At(Byte("draws")));
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_NE(lines[0].find(", page "), std::string::npos) << lines[0];
  EXPECT_EQ(lines[1], "Page 7 of the printed book.");
  EXPECT_EQ(lines[2], "Heading Tides, below it Moon.");
  lines = Say("where", At(Byte("High")));
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[1], "Heading Tides.");
}

TEST_F(BookWalkTest, FollowsANoteAndComesBack) {
  Open(kTides);
  const LoopSnapshot call = At(Byte("[1]") + 1);
  EXPECT_TRUE(Begins(Say("follow", call), "A day of the moon: "));
  const auto back = places_->Go({PlaceWord::kReturn, ""}, At(Byte("A day of")));
  EXPECT_EQ(back, "");
  LoopSnapshot now = At(Byte("[1]") + 1);
  const auto arrival = places_->Arrived(now);
  ASSERT_TRUE(arrival);
  EXPECT_EQ(arrival->sentence.rfind("Back at 1: ", 0), 0U) << arrival->sentence;
  EXPECT_EQ(Say("follow", At(Byte("water"))), Lines{say::NoLinkHere()});
  EXPECT_EQ(Say("follow", At(Byte("far]"))),
            Lines{"This leads out of the book, nothing is fetched: http://far.away/"});
}

TEST_F(BookWalkTest, WordsMeanThePlaceThatWasToldLast) {
  Open(kTides);
  LoopSnapshot hand = At(Byte("High"));
  ASSERT_EQ(places_->Go({PlaceWord::kNextLink, ""}, hand), "");
  EXPECT_TRUE(Begins(Say("follow", hand), "A day of the moon: "));  // before the way is told
  hand = At(Byte("A day of"));
  ASSERT_EQ(places_->Go({PlaceWord::kReturn, ""}, hand), "");
  const auto back = places_->Arrived(At(Byte("High")));
  ASSERT_TRUE(back);
  EXPECT_EQ(back->source, Byte("[1]") + 1);  // to the link, where the hand has not been
  hand = At(Byte("High"));
  ASSERT_EQ(places_->Go({PlaceWord::kFind, "far"}, hand), "");
  hand.page = session_->felt().number;
  ASSERT_TRUE(places_->Arrived(hand));
  EXPECT_EQ(Say("follow", hand),  // the hand still rests where it was
            Lines{"This leads out of the book, nothing is fetched: http://far.away/"});
  EXPECT_TRUE(Begins(Say("my text", hand), "Yours in lessons, by my text: It is far out at noon."));
  Say("bookmark out", hand);
  EXPECT_EQ(memory_.MarkNamed("out")->place.letter, static_cast<std::int64_t>(Byte("far]")));
  // once the hand has come there, and gone on, it is what counts
  EXPECT_FALSE(places_->Arrived(At(Byte("far]"))));
  EXPECT_TRUE(Begins(Say("follow", At(Byte("far]"))), "This leads out"));
  EXPECT_EQ(Say("follow", At(Byte("out at"))), Lines{say::NoLinkHere()});
  Say("bookmark noon", At(Byte("noon")));
  EXPECT_EQ(memory_.MarkNamed("noon")->place.letter, static_cast<std::int64_t>(Byte("noon")));
}

TEST_F(BookWalkTest, AWordThatLeadsNowhereLeavesThePlace) {
  Open(kTides);
  const auto letter = static_cast<std::int64_t>(Byte("helps") + 2);
  walk_->Look(At(static_cast<std::size_t>(letter)));
  walk_->End();
  for (const char* word : {"find zebra", "find next", "go to 99", "go to nosuch",
                           "go to bookmark x", "print 9", "contents 9", "back", "mark"}) {
    Again();
    const LoopSnapshot hand = At(Byte("High"));
    if (const auto said = walk_->Obey(word, hand)) {
      for (const std::string& line : *said) EXPECT_NE(line, "") << word;
    }
    walk_->Look(hand);
    walk_->End();
    EXPECT_EQ(memory_.reading().place.letter, letter) << word;
  }
}

TEST_F(BookWalkTest, FindAloneLeadsToWhereTheWordAtTheTipStandsNext) {
  Open(kTides);
  const std::size_t heading = Byte("Moon");
  for (const std::size_t byte : {heading, heading + 2}) {
    const Lines led = Say("find", At(byte));
    EXPECT_TRUE(Begins(led, "Moon, 2 of 3: ")) << led.front();  // not where the tip is
  }
}

TEST_F(BookWalkTest, ABookmarkOnComingBackIsWhereOneLeftOff) {
  Open(kTides);
  const auto letter = static_cast<std::int64_t>(Byte("helps") + 2);
  walk_->Look(At(static_cast<std::size_t>(letter)));
  walk_->End();
  Again();
  Say("bookmark tea", At(Byte("High")));
  EXPECT_EQ(memory_.MarkNamed("tea")->place.letter, letter);
}

TEST_F(BookWalkTest, LeadsByContentsPrintedPagesAndBookmarks) {
  Open(kTides);
  const Lines contents = Say("contents", At(0));
  ASSERT_EQ(contents.size(), 3U);
  EXPECT_EQ(contents[1].rfind("2: Moon, level 2, page ", 0), 0U) << contents[1];
  for (std::size_t i = 0; i < 3; ++i) {  // the page told is the page that it leads to
    const Lines led = Say("contents " + std::to_string(i + 1), At(0));
    ASSERT_FALSE(led.empty());
    const std::string page = contents[i].substr(contents[i].rfind(", page ") + 2);
    EXPECT_NE(led[0].find(page.substr(0, page.size() - 1) + " of "), std::string::npos)
        << contents[i] << " " << led[0];
  }
  EXPECT_TRUE(Begins(Say("contents 3", At(0)), "Sun: "));
  EXPECT_EQ(Say("contents 4", At(0)), Lines{"No line 4 of the contents: they have 3."});
  EXPECT_TRUE(Begins(Say("go to print 7", At(0)), "Page 7 of the printed book: "));
  EXPECT_EQ(Say("go to print 8", At(0)), Lines{"No printed page 8 is marked here."});
  EXPECT_EQ(Say("mark", At(0)), Lines{say::NoMarks()});
  EXPECT_TRUE(Begins(Say("bookmark Tea time", At(Byte("draws"))), "Bookmark set: Tea time, page "));
  EXPECT_EQ(walk_->Marked({Byte("helps"), {0, 0}}).rfind("Bookmark set: mark 1, ", 0), 0U);
  EXPECT_EQ(Say("bookmarks", At(0)).size(), 2U);
  EXPECT_TRUE(Begins(Say("mark", At(0)), "Bookmark mark 1: "));
  EXPECT_TRUE(Begins(Say("go to tea TIME", At(0)), "Bookmark Tea time: "));
  EXPECT_EQ(Say("go to bookmark lunch", At(0)), Lines{say::NoMarkNamed("lunch")});
  EXPECT_EQ(Say("word", At(Byte("draws"))), Lines{"draws."});
  EXPECT_EQ(Say("spell", At(Byte("sea"))), Lines{"s, e, a, .."});
  Again();
  EXPECT_EQ(memory_.reading().marks.size(), 2U);  // whoever comes back has them
}

TEST_F(BookWalkTest, GoesOnAtTheLetterThatWasTouchedLast) {
  Open(kTides);
  const std::size_t letter = Byte("helps") + 2;
  walk_->Look(At(letter));
  walk_->Look(At(Byte("The sun"), false));  // in the air is not read
  EXPECT_EQ(walk_->End().front().rfind("Kept: page ", 0), 0U);
  Again();
  EXPECT_EQ(memory_.known_by(), KnownBy::kContent);
  EXPECT_EQ(memory_.reading().place.letter, static_cast<std::int64_t>(letter));
  ASSERT_GE(begun_.size(), 3U);
  EXPECT_EQ(begun_[0].rfind("You go on: page ", 0), 0U) << begun_[0];
  EXPECT_NE(begun_[0].find(", at l, in \"Tides\"."), std::string::npos) << begun_[0];
  EXPECT_EQ(begun_[1], "Heading Tides, below it Sun.");
  EXPECT_EQ(begun_[2], "Last read: The sun helps at times.");
}

TEST_F(BookWalkTest, KeepsThePlaceUntilTheHandHasComeToIt) {
  Open(kTides);
  const auto letter = static_cast<std::int64_t>(Byte("helps") + 2);
  walk_->Look(At(static_cast<std::size_t>(letter)));
  walk_->End();
  Again();
  walk_->Look(At(Byte("High")));  // where the hand happens to rest
  walk_->End();
  EXPECT_EQ(memory_.reading().place.letter, letter);
  walk_->Look(At(static_cast<std::size_t>(letter) - 1));  // led to the line, not yet as far
  walk_->End();
  EXPECT_EQ(memory_.reading().place.letter, letter);
  walk_->Look(At(static_cast<std::size_t>(letter) + 1));
  walk_->End();
  EXPECT_EQ(memory_.reading().place.letter, letter + 1);
}

TEST_F(BookWalkTest, IsAtThePlaceThatWasGoneToBeforeItIsTouched) {
  Open(kTides);
  walk_->Arrived(Byte("helps"));
  walk_->End();
  EXPECT_EQ(memory_.reading().place.letter, static_cast<std::int64_t>(Byte("helps")));
}

TEST_F(BookWalkTest, GivesItsSentenceToLessons) {
  Open(kTides);
  EXPECT_TRUE(Begins(Say("my text", At(Byte("draws"))), "Yours in lessons, by my text: The moon"));
  walk_->End();
  memory_ = BookMemory();
  const std::vector<RecordedEvent> events = Records::OpenToRead(In("records.sqlite")).Events("owl");
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].kind, kOwnTextEvent);
  EXPECT_EQ(events[0].text, "The moon draws the sea.");
}

/// A press at a place of what lies there.
LoopEvent PressAt(glm::dvec2 p_P, LoopEventKind kind) {
  LoopEvent event;
  event.kind = kind;
  event.tip_P = glm::dvec3(p_P, 0);
  return event;
}

TEST_F(BookWalkTest, LaysAnswersUnderTheHandAndThePlaceBackAgain) {
  options_.moon = true;
  Open(kTides);
  walk_->ClearPage();
  const LoopSnapshot now = At(Byte("draws"));
  walk_->Look(now);
  const std::size_t page = session_->felt().index;
  EXPECT_EQ(walk_->Pressed(false, PressAt(now.tip_P, LoopEventKind::kSay)).line, "where");
  const auto where = walk_->Obey("where", now);
  ASSERT_TRUE(where);
  EXPECT_EQ(where->front().rfind("page ", 0), 0U) << where->front();  // short, as it is felt
  EXPECT_TRUE(walk_->Answered({"at d", "in Moon"}, now));
  EXPECT_EQ(session_->text().text, "at d\nin Moon");
  LoopSnapshot there = now;
  there.page = session_->felt().number;
  EXPECT_TRUE(walk_->Look(there).empty());  // it is no place of the book
  const Companion::Press press = walk_->Pressed(false, PressAt({0.05, 0.05}, LoopEventKind::kSay));
  EXPECT_TRUE(press.taken);
  EXPECT_EQ(press.line, "");
  EXPECT_EQ(session_->text().text, text_.text);
  EXPECT_EQ(session_->felt().index, page);
  walk_->End();
  EXPECT_EQ(memory_.reading().place.letter, static_cast<std::int64_t>(Byte("draws")));
}

const LoopEvent kBeside = PressAt({-0.5, -0.5}, LoopEventKind::kSay);

TEST_F(BookWalkTest, InMoonWhatIsReadAndWhatTheButtonDoesLieThereFirst) {
  options_.moon = true;
  Open(kTides);
  LoopSnapshot hand = At(0, false);
  walk_->Look(hand);
  EXPECT_EQ(session_->text().text, text_.text) << "in the air nobody would feel where it begins";
  hand.depth = 1e-4;
  walk_->Look(hand);
  EXPECT_TRUE(walk_->trembles());
  EXPECT_EQ(session_->text().text, "Tides\npress: where\ntwice: words\nhold: stop, then press: go");
  walk_->Look(hand);
  EXPECT_FALSE(walk_->trembles());
  walk_->ClearPage();
  walk_->Look(At(Byte("helps") + 2));
  walk_->End();
  Again();
  walk_->Look(At(Byte("helps")));
  EXPECT_EQ(session_->text().text.rfind("Tides\npage ", 0), 0U) << session_->text().text;
  walk_->ClearPage();
  EXPECT_EQ(session_->felt().index, Find(session_->text(), {Byte("helps"), {0, 0}})->page);
  walk_->End();
  EXPECT_EQ(memory_.reading().place.letter, static_cast<std::int64_t>(Byte("helps") + 2));
}

TEST_F(BookWalkTest, EveryPageOfAnAnswerCanBeFelt) {
  options_.moon = true;
  Open(kTides);
  walk_->ClearPage();
  const LoopSnapshot now = At(Byte("draws"));
  std::string long_answer;
  for (int i = 0; i < 40; ++i) long_answer += "many words ";
  for (const bool on_the_line : {true, false}) {
    ASSERT_TRUE(walk_->Answered({long_answer}, now));
    const std::size_t pages = session_->text().set.pages.size();
    ASSERT_GT(pages, 2U);
    for (std::size_t page = 0; page < pages; ++page) {
      ASSERT_EQ(session_->felt().index, page);
      const glm::dvec2 letter_P = session_->felt().set().glyphs[0].origin_P;
      LoopEvent press = kBeside;
      if (on_the_line) press = PressAt(letter_P + glm::dvec2(0.003, 0.006), LoopEventKind::kSay);
      EXPECT_TRUE(walk_->Pressed(false, press).taken);
      walk_->Look(now);
      EXPECT_EQ(walk_->trembles(), page + 1 < pages);
    }
    EXPECT_EQ(session_->text().text, text_.text);
  }
  ASSERT_TRUE(walk_->Answered({long_answer}, now));
  walk_->Pressed(true, kBeside);  // enough of it
  EXPECT_EQ(session_->text().text, text_.text);
}

TEST_F(BookWalkTest, ContentsAndBookmarksAreChosenByAPress) {
  options_.moon = true;
  Open(kTides);
  walk_->ClearPage();
  const LoopSnapshot now = At(Byte("draws"));
  Say("bookmark tea", now);
  const std::vector<std::pair<std::string, std::pair<std::string, std::string>>> lists{
      {"contents", {"Tides\nMoon\nSun", "contents 1"}},
      {"bookmarks", {"tea", "go to bookmark tea"}}};
  for (const auto& [word, list] : lists) {
    const auto lines = walk_->Obey(word, now);
    ASSERT_TRUE(lines);
    ASSERT_TRUE(walk_->Answered(*lines, now));
    EXPECT_EQ(session_->text().text, list.first);
    const glm::dvec2 first_P = session_->felt().set().glyphs[0].origin_P + glm::dvec2(0.003, 0.006);
    LoopEvent press = PressAt(first_P, LoopEventKind::kSay);
    press.tip_P.z = 0.02;
    EXPECT_EQ(walk_->Pressed(false, press).line, "");  // in the air nothing is chosen
    ASSERT_TRUE(walk_->Obey(word, now));
    ASSERT_TRUE(walk_->Answered(*lines, now));
    press.tip_P.z = 0;
    EXPECT_EQ(walk_->Pressed(false, press).line, list.second);
    EXPECT_EQ(session_->text().text, text_.text);
  }
  EXPECT_TRUE(walk_->Answered({"no list any more"}, now));
  EXPECT_EQ(session_->text().text, "no list any more");
}

TEST_F(BookWalkTest, WithoutForceAPressBringsItBackAndChoosesNothing) {
  options_.moon = true;
  Open(kTides);
  walk_->ClearPage();
  LoopSnapshot now = At(Byte("draws"));
  walk_->Pressed(true, PressAt(now.tip_P, LoopEventKind::kBookmark));  // the menu
  const std::string menu = session_->text().text;
  now.stopped = true;
  walk_->Look(now);
  EXPECT_FALSE(walk_->Answered({"No force: you stopped."}, now));  // nothing could be felt
  const glm::dvec2 first_P = session_->felt().set().glyphs[0].origin_P + glm::dvec2(0.003, 0.006);
  for (const bool twice : {false, true}) {
    const Companion::Press press = walk_->Pressed(twice, PressAt(first_P, LoopEventKind::kSay));
    EXPECT_TRUE(press.taken);
    EXPECT_EQ(press.line, "");
    EXPECT_EQ(session_->text().text, menu);
  }
  now.stopped = false;
  walk_->Look(now);
  EXPECT_EQ(walk_->Pressed(false, PressAt(first_P, LoopEventKind::kSay)).line, "next");
}

TEST_F(BookWalkTest, TheEndMustReachWhoCannotHear) {
  options_.moon = options_.alone = true;
  Open(kTides);
  walk_->ClearPage();
  walk_->Look(At(Byte("draws")));
  EXPECT_FALSE(walk_->urgent());
  const std::size_t last = session_->text().set.pages.back().glyphs.back().source_begin;
  walk_->Look(At(last));
  EXPECT_FALSE(walk_->urgent());
  walk_->Look(At(last, false));
  EXPECT_TRUE(walk_->urgent());  // the end
  walk_->Look(At(Byte("draws")));
  EXPECT_FALSE(walk_->urgent());
}

TEST_F(BookWalkTest, HasAMenuForAStylusAlone) {
  options_.moon = true;
  Open(kTides);
  walk_->ClearPage();
  const LoopSnapshot now = At(Byte("draws"));
  std::set<std::string> words;
  for (std::size_t row = 0; row < 100; ++row) {
    EXPECT_TRUE(walk_->Pressed(true, PressAt(now.tip_P, LoopEventKind::kBookmark)).taken);
    // to the row's page by presses beside the words
    std::size_t rows = 0;
    std::optional<glm::dvec2> at_P;
    while (!at_P) {
      for (const PlacedGlyph& glyph : session_->felt().set().glyphs) {
        if (rows + glyph.line == row) at_P = glyph.origin_P + glm::dvec2(0.003, 0.006);
      }
      if (at_P) break;
      rows += session_->felt().set().lines;
      ASSERT_TRUE(walk_->Pressed(false, PressAt({-0.5, -0.5}, LoopEventKind::kSay)).taken);
      if (session_->text().text == text_.text) break;  // behind the last page: the book
    }
    if (!at_P) break;
    const Companion::Press press = walk_->Pressed(false, PressAt(*at_P, LoopEventKind::kSay));
    words.insert(press.line);     // a long word may have two rows
    EXPECT_NE(press.line, "go");  // no menu can be felt where that does something
    EXPECT_EQ(session_->text().text, text_.text);
  }
  for (const char* word : {"next", "back", "where", "next line", "next heading", "next link",
                           "follow", "return", "find", "bookmark", "mark", "contents", "quit"}) {
    EXPECT_EQ(words.count(word), 1U) << word;
  }
  for (const std::string& word : words) {
    EXPECT_NE(ReadLine(word, WordPlace::kBook).word, nullptr) << word;
  }
}

TEST_F(BookWalkTest, KnowsABookAgainThatMovedOrWasEdited) {
  Open(kTides);
  walk_->Look(At(Byte("helps")));
  walk_->End();
  Again("/elsewhere/tides.html");
  EXPECT_EQ(memory_.known_by(), KnownBy::kMoved);
  EXPECT_EQ(begun_[1], say::BookMoved());
  walk_->End();
  Replace(std::string("<p>A preface, new.</p>") + kTides, "/elsewhere/tides.html");
  EXPECT_EQ(memory_.known_by(), KnownBy::kEdited);
  EXPECT_EQ(begun_[1], say::BookEdited(false));
  EXPECT_EQ(memory_.reading().place.letter, static_cast<std::int64_t>(Byte("helps")));
  walk_->End();
  Replace("<p>Quite another book.</p>", "/third.html");
  EXPECT_EQ(memory_.known_by(), KnownBy::kNothing);
  EXPECT_FALSE(memory_.replaced());
}

/// A volume of a series: what it begins with is the same in all.
std::string Volume(const std::string& word) {
  std::string html =
      "<h1>Tides of the world</h1><p>All rights reserved by the harbour office, "
      "which prints these tables for the use of sailors and of nobody else.</p>";
  for (int i = 0; i < 60; ++i) {
    html += "<p>" + word + " number " + std::to_string(i) + " is told here at some length.</p>";
  }
  return html;
}

TEST_F(BookWalkTest, AnotherBookInTheSameFileLeavesTheOldOnesPlaceAndBookmarks) {
  Open(Volume("Harbour"));
  Say("bookmark tea", At(Byte("number 20")));
  walk_->Look(At(Byte("rights")));  // in what is the same in both
  walk_->End();
  const ReadDocument old = memory_.reading();
  Replace(Volume("Island"));
  EXPECT_EQ(memory_.known_by(), KnownBy::kNothing);
  EXPECT_TRUE(memory_.replaced());
  EXPECT_TRUE(begun_.empty());
  EXPECT_TRUE(memory_.reading().marks.empty());
  walk_->Look(At(Byte("number 30")));
  walk_->End();
  memory_ = BookMemory();
  const std::vector<ReadDocument> kept = Records::OpenToRead(In("records.sqlite")).Readings("owl");
  ASSERT_EQ(kept.size(), 2U);
  EXPECT_EQ(kept[0].id == old.id ? kept[0] : kept[1], old);
  // each is known again by what it holds, whichever lies there
  Replace(Volume("Harbour"));
  EXPECT_EQ(memory_.known_by(), KnownBy::kContent);
  EXPECT_EQ(memory_.reading().marks.size(), 1U);
  Replace(Volume("Island"));
  EXPECT_EQ(memory_.known_by(), KnownBy::kContent);
  EXPECT_EQ(memory_.reading().place.letter, static_cast<std::int64_t>(Byte("number 30")));
}

TEST_F(BookWalkTest, OfAnotherTitleOrAnotherFileItIsAnotherBook) {
  Open(Volume("Harbour"));
  walk_->End();
  Replace("<p>One more line.</p>" + Volume("Harbour"), "/books/copy.html");
  EXPECT_EQ(memory_.known_by(), KnownBy::kNothing);  // of the same title
  EXPECT_FALSE(memory_.replaced());
  walk_->End();
  book_.title = "Winds";
  Replace("<p>One line.</p>" + Volume("Harbour"));
  EXPECT_EQ(memory_.known_by(), KnownBy::kNothing);
  EXPECT_TRUE(memory_.replaced());
}

TEST_F(BookWalkTest, SaysWhichBookmarksAnEditHasLost) {
  Open(Volume("Harbour"));
  Say("bookmark tea", At(Byte("number 20")));
  Say("bookmark cake", At(Byte("number 40")));
  walk_->Look(At(Byte("number 20")));
  walk_->End();
  std::string changed = Volume("Harbour");
  for (int i = 19; i < 22; ++i) {
    const std::string words =
        "<p>Harbour number " + std::to_string(i) + " is told here at some length.</p>";
    changed.erase(changed.find(words), words.size());
  }
  Replace(changed);
  EXPECT_EQ(memory_.known_by(), KnownBy::kEdited);
  ASSERT_EQ(memory_.lost_marks().size(), 1U);
  EXPECT_EQ(memory_.lost_marks()[0].name, "tea");
  ASSERT_EQ(memory_.reading().marks.size(), 1U);
  EXPECT_EQ(memory_.reading().marks[0].place.letter, static_cast<std::int64_t>(Byte("number 40")));
  EXPECT_TRUE(memory_.place_gone());
  EXPECT_EQ(begun_[1], say::BookEdited(true));
  const auto near = static_cast<std::size_t>(memory_.reading().place.letter);
  EXPECT_GT(near, Byte("number 16"));
  EXPECT_LT(near, Byte("number 26"));
}

TEST_F(BookWalkTest, WhatAnOlderVersionKeptIsKnownByItsPlaceAlone) {
  Open(Volume("Harbour"));
  walk_->Look(At(Byte("number 20")));
  walk_->End();
  ReadDocument old = memory_.reading();
  memory_ = BookMemory();
  old.landmarks.clear();
  Records::Open(In("records.sqlite")).Keep("owl", old);
  Replace("<p>One more line.</p>" + Volume("Harbour"));
  EXPECT_EQ(memory_.known_by(), KnownBy::kEdited);
  EXPECT_EQ(memory_.reading().place.letter, static_cast<std::int64_t>(Byte("number 20")));
  memory_ = BookMemory();
  Records::Open(In("records.sqlite")).Keep("owl", old);
  Replace(Volume("Island"));
  EXPECT_EQ(memory_.known_by(), KnownBy::kNothing);
}

TEST_F(BookWalkTest, BookmarksOfNumbersAreReachedMovedAndForgottenByWords) {
  Open(kTides);
  EXPECT_TRUE(Begins(Say("bookmark 2", At(Byte("draws"))), "Bookmark set: 2, page "));
  EXPECT_TRUE(Begins(Say("go to bookmark 2", At(0)), "Bookmark 2: page "));
  const Lines page = Say("go to 2", At(0));
  EXPECT_EQ(std::count(page.begin(), page.end(), say::MarkToo("2")), 1) << page[0];
  EXPECT_TRUE(Begins(Say("bookmark 2", At(Byte("helps"))), "Bookmark moved: 2, from page "));
  EXPECT_TRUE(Begins(Say("print 7", At(0)), "Page 7 of the printed book: "));
  EXPECT_EQ(Say("print 8", At(0)), Lines{"No printed page 8 is marked here."});
  walk_->Marked({Byte("High"), {0, 0}});
  EXPECT_TRUE(Begins(Say("go to bookmark 1", At(Byte("helps"))), "Bookmark mark 1: page "));
  EXPECT_EQ(Say("forget", At(0)), Lines{say::ForgetWhat()});
  EXPECT_EQ(Say("forget lunch", At(0)), Lines{say::NoMarkNamed("lunch")});
  EXPECT_EQ(Say("forget bookmark 2", At(0)), Lines{say::MarkForgotten("2")});
  Again();
  ASSERT_EQ(memory_.reading().marks.size(), 1U);
  EXPECT_EQ(memory_.reading().marks[0].name, "mark 1");
}

TEST_F(BookWalkTest, GoToSaysWhatMayFollow) {
  Open(kTides);
  const std::string pages = std::to_string(session_->text().set.pages.size());
  const Lines second = Say("go to 2", At(0));
  for (const char* line : {"go to page 2", "Go to page 2.", "go to 2!"}) {
    EXPECT_EQ(Say(line, At(0)), second) << line;
  }
  EXPECT_EQ(Say("go to page 99", At(0)), Lines{"No page 99: say go to 1 to " + pages + "."});
  const std::string may = "go to 1 to " + pages + ", print 12, or a bookmark's name.";
  EXPECT_EQ(Say("go to", At(0)), Lines{"Say where: " + may});
  for (const char* where : {"line 3", "start", "end", "contents"}) {
    const std::string line = std::string("go to ") + where;
    EXPECT_EQ(Say(line, At(0)), Lines{std::string("No bookmark ") + where + ": " + may});
  }
  Say("bookmark start", At(Byte("draws")));
  Say("bookmark page 2", At(Byte("High")));
  EXPECT_TRUE(Begins(Say("go to start.", At(0)), "Bookmark start: "));
  EXPECT_TRUE(Begins(Say("go to page 2", At(0)), "Bookmark page 2: ")) << "of that very name";
}

TEST_F(BookWalkTest, ALinkToNothingLeavesTheHandWhereItIs) {
  Open("<p>High <a href='#gone'>water</a> comes.</p>");
  EXPECT_EQ(Say("follow", At(Byte("water"))),
            Lines{"What this leads to is not in the text: #gone"});
  EXPECT_FALSE(places_->Going());
}

// The same sentence was said again at the end.
TEST_F(BookWalkTest, WhatCannotBeKeptIsToldOnce) {
  Open(kTides);
  EXPECT_FALSE(walk_->lost());
  signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit none{0, before.rlim_max};  // as on a full disk
  setrlimit(RLIMIT_FSIZE, &none);
  LoopSnapshot stopped = At(Byte("draws"));
  stopped.stopped = true;
  const Lines told = walk_->Look(stopped);
  const Lines end = walk_->End();
  const bool lost = walk_->lost();
  setrlimit(RLIMIT_FSIZE, &before);
  ASSERT_FALSE(told.empty());
  EXPECT_EQ(told.back().rfind("Your place is not kept: ", 0), 0U) << told.back();
  EXPECT_EQ(end, Lines{});
  EXPECT_TRUE(lost);
  EXPECT_EQ(walk_->End().size(), 1U) << "there is room again";
  EXPECT_FALSE(walk_->lost());
}

TEST_F(BookWalkTest, ABookmarkIsNotSaidToBeSetWhereNothingIsKept) {
  Open(kTides);
  memory_ = BookMemory();
  EXPECT_TRUE(
      Begins(Say("bookmark tea", At(Byte("draws"))), "Bookmark until you quit, not kept: "));
  EXPECT_TRUE(walk_->End().empty());
}

TEST_F(BookWalkTest, WhatWasFoundIsThePlaceUntilTheHandHasComeToIt) {
  Open(kTides);
  const LoopSnapshot hand = At(Byte("High"));
  walk_->Look(hand);
  ASSERT_EQ(walk_->Obey("find times", hand), Lines{""});  // the way is told on arrival
  walk_->Look(hand);                                      // before the way was told
  walk_->End();
  EXPECT_EQ(memory_.reading().place.letter, static_cast<std::int64_t>(Byte("times")));
  LoopSnapshot there = At(Byte("times"));
  const auto arrival = places_->Arrived(there);
  ASSERT_TRUE(arrival);
  walk_->Arrived(arrival->source);
  there = At(session_->felt().set().glyphs.front().source_begin);
  walk_->Look(there);  // the hand rests elsewhere
  walk_->End();
  EXPECT_EQ(memory_.reading().place.letter, static_cast<std::int64_t>(Byte("times")));
  walk_->Look(At(Byte("times") + 2));
  walk_->End();
  EXPECT_EQ(memory_.reading().place.letter, static_cast<std::int64_t>(Byte("times") + 2));
}

TEST_F(BookWalkTest, HowManyWordsAreLeftOutIsLaidUnderAHandThatCannotHear) {
  options_.moon = options_.known = true;
  options_.news = {"Left out: 2 of 9 words."};
  Open(kTides);
  walk_->Look(At(0));
  EXPECT_EQ(session_->text().text.rfind("Tides\nLeft out: 2 of 9 words.\n", 0), 0U);
}

TEST_F(BookWalkTest, ForAHandThatKnowsLettersOnlyThePageIsTurnedBehindItsLast) {
  options_.alone = true;
  Open(kTides);
  const std::size_t pages = session_->text().set.pages.size();
  ASSERT_GT(pages, 1U);
  for (std::size_t page = 0; page < pages; ++page) {
    ASSERT_EQ(session_->felt().index, page);
    EXPECT_FALSE(walk_->ended());
    LoopSnapshot now = At(session_->felt().set().glyphs.back().source_begin);
    walk_->Look(now);
    EXPECT_EQ(session_->felt().index, page) << "while it is felt";
    now.depth = -0.001;
    const Lines said = walk_->Look(now);
    EXPECT_TRUE(Begins(said, page + 1 < pages ? "Page " : say::TheEnd()));
  }
  EXPECT_TRUE(walk_->ended());
}

TEST_F(BookWalkTest, TheTurnMarkTurnsThePageOnceItIsReachedFromBesideIt) {
  options_.turns = true;
  Open(kTides);
  const std::size_t pages = session_->text().set.pages.size();
  ASSERT_GT(pages, 1U);
  const Box mark_P = TurnMark(session_->text().set.page).box_P;
  const glm::dvec2 on_P = 0.5 * (mark_P.min + mark_P.max);
  LoopSnapshot now = At(Byte("High"));
  EXPECT_FALSE(Begins(walk_->Look(now), "Page "));
  now.tip_P = glm::dvec3(on_P, 0);
  now.depth = -0.001;
  EXPECT_FALSE(Begins(walk_->Look(now), "Page ")) << "above the paper";
  now.depth = 1e-4;
  EXPECT_TRUE(Begins(walk_->Look(now), "Page 2 of "));
  EXPECT_TRUE(walk_->trembles());  // which trembles
  now.page = session_->felt().number;
  EXPECT_FALSE(Begins(walk_->Look(now), "Page ")) << "the tip still lies where it turned the page";
  EXPECT_FALSE(walk_->trembles());
  EXPECT_EQ(session_->felt().index, 1U);
  for (std::size_t page = 2; page <= pages; ++page) {
    now.tip_P = glm::dvec3(session_->felt().set().glyphs.front().origin_P, 0);
    walk_->Look(now);
    now.tip_P = glm::dvec3(on_P, 0);
    EXPECT_TRUE(Begins(walk_->Look(now), page < pages ? "Page " : say::TheEnd()));
    now.page = session_->felt().number;
  }
  EXPECT_FALSE(walk_->ended());  // who reads may go back
}

TEST_F(BookWalkTest, APageThatWasTurnedAtItsMarkIsWhereReadingGoesOn) {
  options_.turns = true;
  Open(kTides);
  ASSERT_GT(session_->text().set.pages.size(), 1U);
  walk_->Look(At(Byte("High")));
  walk_->End();
  Again();  // the hand has not come to where reading goes on
  const Box mark_P = TurnMark(session_->text().set.page).box_P;
  LoopSnapshot now = At(Byte("High"));
  now.tip_P = glm::dvec3(mark_P.max + glm::dvec2(0, 0.001), 0);
  walk_->Look(now);
  now.tip_P = glm::dvec3(0.5 * (mark_P.min + mark_P.max), 0);
  EXPECT_TRUE(Begins(walk_->Look(now), "Page 2 of "));
  now.page = session_->felt().number;
  walk_->Look(now);
  const auto kept = static_cast<std::size_t>(memory_.reading().place.letter);
  EXPECT_EQ(Find(session_->text(), {kept, {0.5, 0.5}})->page, 1U);
}

TEST_F(BookWalkTest, TheTurnMarkIsFeltBelowTheTextAndClearOfIt) {
  options_.turns = true;
  Open(kTides);
  const PageSpec& page = session_->text().set.page;
  const PaperPatch mark = TurnMark(page);
  EXPECT_LT(mark.box_P.max.y, page.margin);
  EXPECT_GE(mark.box_P.min.y, 0);
  EXPECT_LE(mark.box_P.max.x, page.width);
  // as rough as a grid of twice 50 um over 2 mm is: its quarter-wave rises by the amplitude
  double least = 0, greatest = 0;
  for (int i = 0; i <= 200; ++i) {
    const double share = i / 200.0;
    const glm::dvec2 p_P = mark.box_P.min + share * (mark.box_P.max - mark.box_P.min);
    const double height = session_->felt().field->SampleAt(p_P).displacement;
    least = std::min(least, height);
    greatest = std::max(greatest, height);
  }
  EXPECT_GT(greatest - least, 50e-6);
  const std::size_t first = session_->felt().set().glyphs.front().source_begin;
  const glm::dvec2 beside_P = Find(session_->text(), {first, {0.5, -0.5}})->p_P;
  EXPECT_EQ(session_->felt().field->SampleAt(beside_P).displacement, 0);
}

TEST(TurnMarkTest, WantsAMargin) {
  PageSpec page;
  page.margin = 0.003;
  EXPECT_THROW(TurnMark(page), InputError);
}

}  // namespace
}  // namespace moontrace
