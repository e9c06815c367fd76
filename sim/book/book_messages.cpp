#include "sim/book/book_messages.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <ctime>

#include "sim/console/vocabulary.h"
#include "sim/console/wording.h"
#include "textures/base/text_file.h"
#include "textures/base/utf8.h"

namespace moontrace::say {

std::string BookPlace(std::size_t page, std::size_t pages, std::size_t line,
                      std::string_view letter) {
  std::string place = fmt::format("page {} of {}, line {}", page + 1, pages, line + 1);
  if (!letter.empty()) place += fmt::format(", at {}", OneLine(letter));
  return place;
}

std::string BackInBook(std::string_view title, std::string_view place) {
  return fmt::format("You go on: {}, in {}.", place, Quoted(OneLine(title, 100)));
}
std::string BookMoved() { return "The file lay elsewhere before; it holds the same text."; }
std::string BookEdited(bool place_gone) {
  return place_gone ? "The text was changed since, and the words at your place are gone: you go on "
                      "near where they stood."
                    : "The text was changed since; your place is where the same words stand now.";
}
std::string BookReplaced() {
  return "Another text lay in this file before. What you kept of it stays: moontrace read lists "
         "it.";
}
std::string LastRead(std::string_view sentence) {
  return fmt::format("Last read: {}", OneLine(sentence, 450));
}

std::string BelowHeadings(const std::vector<std::string>& headings) {
  std::vector<std::string> shown;
  shown.reserve(headings.size());
  for (const std::string& heading : headings) shown.push_back(OneLine(heading, 60));
  return fmt::format("Heading {}.", Joined(shown, ", below it "));
}
std::string PrintedPage(std::string_view name) {
  return fmt::format("Page {} of the printed book.", OneLine(name, 20));
}
std::string GoesOnHere() { return "The line where you go on"; }

std::string WordHere(std::string_view word, bool spelt) {
  if (!spelt) return fmt::format("{}.", OneLine(word, 60));
  std::vector<std::string> letters;
  for (std::size_t i = 0; i < word.size() && letters.size() < 60;) {
    char32_t c = 0;
    const std::size_t length = std::max<std::size_t>(1, Decode(word.substr(i), c));
    letters.push_back(OneLine(word.substr(i, length)));
    i += length;
  }
  return fmt::format("{}.", Joined(letters, ", "));
}
std::string NoWordHere() { return "No word here."; }

std::string NumberedContents(std::size_t number, const ContentsEntry& entry, std::size_t page) {
  const std::string nowhere = entry.group ? "without a place" : "leads nowhere";
  const std::string where = entry.block == kNoBlock ? nowhere : fmt::format("page {}", page + 1);
  return fmt::format("{}: {}{}, {}.", number, OneLine(entry.title, 60),
                     entry.level > 1 ? fmt::format(", level {}", entry.level) : "", where);
}
std::string NoContents() { return "No contents: this text has no headings."; }
std::string ContentsRest(std::size_t count, std::size_t last) {
  return fmt::format("And {} more: contents with a number up to {} leads there.", count, last);
}
std::string NoSuchContents(std::string_view number, std::size_t count) {
  return fmt::format("No line {} of the contents: they have {}.", OneLine(number, 12), count);
}
std::string LeadsNowhere(std::string_view title) {
  return fmt::format("That line leads nowhere: {}.", OneLine(title, 60));
}
std::string NoSuchPrintPage(std::string_view name) {
  return fmt::format("No printed page {} is marked here.", OneLine(name, 20));
}

std::string NoLinkHere() { return "No link here: next link leads to one."; }
std::string LeadsOut(std::string_view address) {
  return fmt::format("This leads out of the book, nothing is fetched: {}", OneLine(address, 200));
}
std::string LeadsToNothing(std::string_view address) {
  return fmt::format("What this leads to is not in the text: {}", OneLine(address, 200));
}
std::string Followed(std::string_view words) { return OneLine(words, 24); }

std::string NotSet(std::string_view words) {
  return fmt::format("Not set: {}.", OneLine(words, 300));
}
std::string KnowsNothing(std::string_view learner) {
  if (learner.empty()) return "--known needs a learner: add --learner NAME";
  return fmt::format("--known: {} has been taught no sign yet; say moontrace learn",
                     OneLine(learner, 60));
}
std::string LineFollowed(std::size_t page, std::size_t pages, std::size_t line,
                         std::string_view words) {
  return fmt::format("Page {} of {}, line {}: {}", page + 1, pages, line + 1, OneLine(words, 300));
}
std::string BookGreeting(std::string_view title, std::string_view learner) {
  return fmt::format("{} reads {}. Say where for the place, ? for the words.", OneLine(learner, 60),
                     Quoted(OneLine(title, 100)));
}
std::string PassageComes() {
  return "Tutor sends a text: it lies under your hand; a press or a word brings the book back.";
}
std::string PassageCannotBe() { return "Not sent: the script cannot write that text."; }
std::string PassageWanted() { return "my text wants the text that is to be read behind it."; }
std::string NotInBook(std::string_view word) {
  return fmt::format("{} is for lessons; here somebody reads.", OneLine(word, 20));
}
std::string NothingRestsHere() { return "Nothing rests: the reading goes on."; }
std::string TutorGoneFromBook() { return "You have left; the reading goes on."; }
std::string TutorWordsInBook() {
  return "say and a text is told; my text and a text lies under the hand to be read. The reader's "
         "words move the reader: next, find moon, go to 4, contents.";
}

std::string NameOfMark(std::size_t number) { return fmt::format("mark {}", number); }
std::string MarkSet(std::string_view name, std::string_view place) {
  return fmt::format("Bookmark set: {}, {}.", OneLine(name, 24), place);
}
std::string MarkMoved(std::string_view name, std::string_view from, std::string_view place) {
  return fmt::format("Bookmark moved: {}, from {} to {}.", OneLine(name, 24), from, place);
}
std::string MarkForNow(std::string_view name, std::string_view place) {
  return fmt::format("Bookmark until you quit, not kept: {}, {}.", OneLine(name, 24), place);
}
std::string MarkLost(std::string_view name, std::string_view words) {
  return fmt::format("Bookmark lost: {}. Its words are gone from the text: {}", OneLine(name, 24),
                     OneLine(words, 200));
}
std::string MarkForgotten(std::string_view name) {
  return fmt::format("Bookmark forgotten: {}.", OneLine(name, 24));
}
std::string ForgetWhat() {
  return "forget wants the name of a bookmark behind it: bookmarks lists them.";
}
std::string MarkToo(std::string_view name) {
  return fmt::format("A bookmark is called {} too: go to bookmark {} leads there.",
                     OneLine(name, 24), OneLine(name, 24));
}
std::string MarkLine(std::string_view name, std::string_view place) {
  return fmt::format("{}: {}.", OneLine(name, 24), place);
}
std::string MarkIs(std::string_view name) { return fmt::format("Bookmark {}", OneLine(name, 24)); }
namespace {
std::string Places(std::size_t pages) {
  return fmt::format("go to {}, print 12, or a bookmark's name",
                     pages > 1 ? fmt::format("1 to {}", pages) : "1");
}
}  // namespace
std::string GoToWhat(std::size_t pages) { return fmt::format("Say where: {}.", Places(pages)); }
std::string NoSuchPlace(std::string_view given, std::size_t pages) {
  return fmt::format("No bookmark {}: {}.", OneLine(given, 16), Places(pages));
}
std::string NoMarks() { return "No bookmark yet: press twice, or say bookmark."; }
std::string NoMarkNamed(std::string_view name) {
  return fmt::format("No bookmark {}: bookmarks lists them.", OneLine(name, 16));
}

std::string ShortTitle(std::string_view title) { return OneLine(title, 30); }
std::string NumberedTitle(std::size_t number, std::string_view title, std::string_view learner) {
  const std::string whose = learner.empty() ? "" : ", " + ShortTitle(learner);
  return fmt::format("{} {}{}", number, ShortTitle(title), whose);
}
std::vector<std::string> PressesInMoon() {
  return {"press: where", "twice: words", "hold: stop, then press: go"};
}
std::vector<std::string> MoonMenu() {
  constexpr std::string_view kLast = "quit";
  std::vector<std::string> menu;
  for (const TypedWord& word : Vocabulary()) {
    // what wants a text cannot be said by a stylus alone; where no force is, no menu can be felt
    constexpr std::array<std::string_view, 3> kAlone{"contents", "bookmark", "find"};
    constexpr std::array<std::string_view, 2> kByButton{"stop", "go"};
    const auto among = [&word](const auto& words) {
      return std::find(words.begin(), words.end(), word.word) != words.end();
    };
    if (!word.HoldsIn(WordPlace::kBook) || among(kByButton) || word.word == kLast) continue;
    if (word.behind.empty() || among(kAlone)) menu.emplace_back(word.word);
  }
  menu.emplace_back(kLast);  // far from what is often pressed
  return menu;
}

std::string PassageTaken(std::string_view text) {
  return fmt::format("Yours in lessons, by my text: {}", OneLine(text, 200));
}
std::string AskWhoReads() { return "who reads?"; }
std::string AskWhichText() { return "read which?"; }
std::string NoneOfThem() { return "another"; }
std::string TheEnd() { return "This is the end of the text."; }
std::string PlaceKept(std::string_view place) { return fmt::format("Kept: {}.", place); }
std::string PlaceNotKept(std::string_view why) {
  return fmt::format("Your place is not kept: {}.", OneLine(why, 300));
}
std::string PlaceLost() { return "place and bookmarks could not be kept in the records"; }
std::string ReadsWithoutName() {
  return "Your place is not kept: say who reads, with --learner NAME.";
}
std::string ReadsWithoutRecords() {
  return "Your place is not kept: Moontrace was built without SQLite.";
}
std::string NewReader(std::string_view name) {
  return fmt::format("{} reads for the first time; places are kept.", OneLine(name, 60));
}
std::string SimulatedReader(std::string_view name) {
  return fmt::format("{} is a simulated learner: choose another name", OneLine(name, 60));
}

std::string NothingRead() { return "Nothing was read yet: say moontrace read FILE."; }
std::string ReadOutcome(std::size_t count) {
  return "Read last: " + Counted(count, "text.", "texts, the newest first.");
}
std::string ReadLineOf(std::size_t number, const ReadDocument& reading, std::string_view learner) {
  const auto time = static_cast<std::time_t>(reading.time);
  std::tm day{};
  char date[16] = "";
  if (localtime_r(&time, &day) != nullptr) {
    std::strftime(date, sizeof date, "%Y-%m-%d", &day);
  }
  const std::string who = learner.empty() ? "" : fmt::format(", {}", OneLine(learner, 60));
  return fmt::format("{}: {}, {}, {}{}.", number, OneLine(reading.title, 100),
                     OneLine(reading.where, 200), date, who);
}
std::string FileIsGone() { return "That file is gone; it may lie elsewhere:"; }
std::string FileHoldsAnother() { return "That file holds another text now:"; }
std::string HowToReadNumbered() {
  return "moontrace read and a number opens that one, with --forget its place is forgotten.";
}
std::string NoReadingNumbered(std::string_view number, std::size_t count) {
  return fmt::format("{}: no file, and no number of the list, which has {}; moontrace read says it",
                     OneLine(number, 20), Counted(count, "text", "texts"));
}
std::string NotInFile(std::string_view number) {
  return fmt::format("number {} came by standard input; name a file that holds it",
                     OneLine(number, 20));
}
std::string NumberIsGone(std::string_view number, std::string_view path) {
  return fmt::format("number {}: its file is gone, {}; name it where it lies now",
                     OneLine(number, 20), OneLine(path, 300));
}
std::string NumberHoldsAnother(std::string_view number, std::string_view path) {
  return fmt::format("number {}: another text is in its file now, {}; name a file that holds it",
                     OneLine(number, 20), OneLine(path, 300));
}
std::string NeverRead(std::string_view file) {
  return fmt::format("{}: nothing is kept of it; moontrace read lists what was read",
                     OneLine(file, 200));
}
std::string ReadingForgotten(const ReadDocument& reading, std::string_view learner) {
  return fmt::format("Forgotten: the place of {} in {}, and {}. The file stays.",
                     OneLine(learner, 60), Quoted(OneLine(reading.title, 100)),
                     Counted(reading.marks.size(), "bookmark", "bookmarks"));
}

}  // namespace moontrace::say
