#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/documents/document.h"
#include "lessons/records/readings.h"

/// Sentences about a book that is read.
namespace moontrace::say {

/// "page 3 of 12, line 2, at m". Page and line from 0.
std::string BookPlace(std::size_t page, std::size_t pages, std::size_t line,
                      std::string_view letter);
/// Where reading goes on.
std::string BackInBook(std::string_view title, std::string_view place);
std::string BookMoved();
/// `place_gone`: the words at the place are no longer there.
std::string BookEdited(bool place_gone);
/// Something else was read in the file before.
std::string BookReplaced();
std::string LastRead(std::string_view sentence);
/// `headings`: the outermost first.
std::string BelowHeadings(const std::vector<std::string>& headings);
std::string PrintedPage(std::string_view name);
std::string GoesOnHere();

/// A word under the tip; `spelt`: letter by letter.
std::string WordHere(std::string_view word, bool spelt);
std::string NoWordHere();

/// A line of the contents with its number; `page` from 0; kNoBlock leads nowhere.
std::string NumberedContents(std::size_t number, const ContentsEntry& entry, std::size_t page);
std::string NoContents();
std::string ContentsRest(std::size_t count, std::size_t last);
std::string NoSuchContents(std::string_view number, std::size_t count);
std::string LeadsNowhere(std::string_view title);
std::string NoSuchPrintPage(std::string_view name);

std::string NoLinkHere();
/// Foreign text.
std::string LeadsOut(std::string_view address);
std::string LeadsToNothing(std::string_view address);
std::string Followed(std::string_view words);

/// Words that the learner has no signs for.
std::string NotSet(std::string_view words);
/// Why `--known` cannot be done; `learner` may be empty.
std::string KnowsNothing(std::string_view learner);
/// For a tutor: the line that is read. Page and line from 0.
std::string LineFollowed(std::size_t page, std::size_t pages, std::size_t line,
                         std::string_view words);
/// What a tutor is met with.
std::string BookGreeting(std::string_view title, std::string_view learner);
std::string PassageComes();
std::string PassageCannotBe();
std::string PassageWanted();
std::string NotInBook(std::string_view word);
std::string NothingRestsHere();
std::string TutorWordsInBook();
std::string TutorGoneFromBook();

/// Of one that nobody named, counted from 1.
std::string NameOfMark(std::size_t number);
std::string MarkSet(std::string_view name, std::string_view place);
/// One of that name was there already; `from`: where.
std::string MarkMoved(std::string_view name, std::string_view from, std::string_view place);
/// Nothing is kept.
std::string MarkForNow(std::string_view name, std::string_view place);
/// By an edit; `words`: that stood there.
std::string MarkLost(std::string_view name, std::string_view words);
std::string MarkForgotten(std::string_view name);
std::string ForgetWhat();
/// Behind the way to a page: a bookmark has that name too.
std::string MarkToo(std::string_view name);
std::string MarkLine(std::string_view name, std::string_view place);
std::string MarkIs(std::string_view name);
/// "go to" without anything behind it, and with what is neither a place nor a bookmark.
std::string GoToWhat(std::size_t pages);
std::string NoSuchPlace(std::string_view given, std::size_t pages);
std::string NoMarks();
std::string NoMarkNamed(std::string_view name);

/// Of a line that is felt, or chosen among others.
std::string ShortTitle(std::string_view title);
/// Likewise, where two may be alike. `learner`: empty where all are of one.
std::string NumberedTitle(std::size_t number, std::string_view title, std::string_view learner);
/// What the button does, a line each.
std::vector<std::string> PressesInMoon();
/// The words that a stylus alone can say.
std::vector<std::string> MoonMenu();
/// It is for lessons.
std::string PassageTaken(std::string_view text);
std::string TheEnd();
std::string AskWhoReads();
std::string AskWhichText();
/// Of the names that were offered.
std::string NoneOfThem();
std::string PlaceKept(std::string_view place);
std::string PlaceNotKept(std::string_view why);
/// At the end, as an error; why has been told.
std::string PlaceLost();
std::string ReadsWithoutName();
std::string ReadsWithoutRecords();
std::string NewReader(std::string_view name);
std::string SimulatedReader(std::string_view name);

/// `read` alone: what was read, with its place.
std::string NothingRead();
std::string ReadOutcome(std::size_t count);
/// `number`: from 1; `learner`: empty where it goes without saying.
std::string ReadLineOf(std::size_t number, const ReadDocument& reading, std::string_view learner);
/// Each before the path of the file.
std::string FileIsGone();
std::string FileHoldsAnother();
std::string HowToReadNumbered();
std::string NoReadingNumbered(std::string_view number, std::size_t count);
/// Why a number cannot be opened; `path`: where the file lay.
std::string NotInFile(std::string_view number);
std::string NumberIsGone(std::string_view number, std::string_view path);
std::string NumberHoldsAnother(std::string_view number, std::string_view path);
std::string NeverRead(std::string_view file);
std::string ReadingForgotten(const ReadDocument& reading, std::string_view learner);

}  // namespace moontrace::say
