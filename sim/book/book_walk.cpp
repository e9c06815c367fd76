#include "sim/book/book_walk.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "sim/book/book_messages.h"
#include "sim/book/unset_words.h"
#include "sim/console/word_messages.h"
#include "sim/session/loop_messages.h"
#include "sim/session/place_messages.h"
#include "sim/session/tip_words.h"
#include "sim/session/turn_mark.h"
#include "textures/base/error.h"
#include "textures/base/utf8.h"

namespace moontrace {

namespace {

constexpr std::chrono::seconds kKeptEvery{2};        ///< while the hand moves on
constexpr std::size_t kMostStrays = 1000;            ///< looks, 20 s: who reads elsewhere, is there
constexpr std::size_t kMostContents = 100;           ///< lines said
constexpr glm::dvec2 kInLetter{0.25, 0.5};           ///< [em]
constexpr std::string_view kBookmark = "bookmark ";  ///< before a bookmark's name
constexpr std::string_view kPage = "page ";          ///< before a page's number

/// The first letter of the line of the text that a letter stands on.
std::size_t LineStart(const TextSetup& text, std::size_t letter) {
  const std::optional<FoundPlace> found = Find(text, {letter, kInLetter});
  if (!found) return letter;
  for (const PlacedGlyph& glyph : text.set.pages[found->page].glyphs) {
    if (glyph.line == found->line) return glyph.source_begin;
  }
  return letter;
}

}  // namespace

BookWalk::BookWalk(LoopSession& session, const Book& book, BookMemory& memory,
                   const BookOptions& options)
    : session_(session), book_(book), memory_(memory), options_(options), laid_(session) {
  const auto letter = static_cast<std::size_t>(memory.reading().place.letter);
  letter_ = std::min(letter, book.text.text.size());
  coming_ = memory.known_by() != KnownBy::kNothing;
}

std::string BookWalk::PlaceInWords(std::size_t letter) const {
  const std::optional<FoundPlace> found = Find(laid_.text(), {letter, kInLetter});
  if (!found) return {};
  return say::BookPlace(found->page, laid_.text().set.pages.size(), found->line, found->letter);
}

/// Where a word about a place means: the place that was told last, as long as the hand has not gone
/// elsewhere from it; when reading goes on, the letter that was read last, not its line's start.
std::optional<std::size_t> BookWalk::Here(const LoopSnapshot& now) {
  const std::optional<LetterPlace> here = walk_->Here(now);
  if (!here) return std::nullopt;
  const bool goes_on = coming_ && here->source == LineStart(session_.text(), letter_);
  return goes_on ? letter_ : here->source;
}

std::vector<std::string> BookWalk::Begin(PlaceWalk& walk) {
  walk_ = &walk;
  kept_page_ = session_.felt().index;
  if (options_.moon) BeginInMoon();
  if (!coming_) return {};
  Lines lines{say::BackInBook(book_.title, PlaceInWords(letter_))};
  if (memory_.known_by() == KnownBy::kMoved) lines.push_back(say::BookMoved());
  if (memory_.known_by() == KnownBy::kEdited) {
    lines.push_back(say::BookEdited(memory_.place_gone()));
  }
  std::vector<std::string> headings;
  for (const std::size_t block : HeadingTrail(book_.document, BlockAt(book_.text, letter_))) {
    headings.push_back(book_.document.blocks[block].text);
  }
  if (!headings.empty()) lines.push_back(say::BelowHeadings(headings));
  const std::size_t here = BlockAt(book_.text, letter_);
  if (book_.document.blocks[here].kind != BlockKind::kHeading) {
    lines.push_back(say::LastRead(ReadAt(book_.document, book_.text, letter_)));
  }
  if (opening_.lines.empty()) {
    lines.push_back(walk.Begin(LineStart(session_.text(), letter_), say::GoesOnHere()));
  }
  kept_page_ = session_.felt().index;
  return lines;
}

/// What is read, where, and what the button does: laid once the hand touches the page, so that it
/// begins under the tip. A press brings the line's start there.
void BookWalk::BeginInMoon() {
  const std::size_t start = coming_ ? LineStart(session_.text(), letter_) : 0;
  const std::optional<std::size_t> letter = LetterFrom(session_.text(), start);
  const std::optional<FoundPlace> found =
      letter ? Find(session_.text(), {*letter, kInLetter}) : std::nullopt;
  if (!found) return;
  if (found->page != session_.felt().index) session_.TurnTo(found->page);
  std::vector<LaidLines::Line> lines{{say::ShortTitle(book_.title), ""}};
  if (coming_) lines.push_back({PlaceInWords(letter_), ""});
  for (const std::string& line : options_.news) lines.push_back({line, ""});
  for (const std::string& line : say::PressesInMoon()) lines.push_back({line, ""});
  opening_ = {std::move(lines), found->p_P};
}

std::optional<std::vector<std::string>> BookWalk::Obey(std::string_view line,
                                                       const LoopSnapshot& now) {
  const SaidLine said = ReadLine(line, WordPlace::kBook);
  if (said.word == nullptr) return ToPrintPage(line, now);
  const std::string_view name = said.word->word;
  if (name == "where") return Where(now);
  if (name == "contents") return Contents(said.behind, now);
  if (name == "go to") return GoTo(said.behind, now);
  if (name == "follow") return Follow(now);
  if (name == "mark") return Lines{ToMark("", now)};
  if (name == "bookmarks") return Bookmarks();
  if (name == "forget") return Lines{ForgetMark(said.behind)};
  const std::optional<NearLetter> near = LetterNear(session_.felt(), now.tip_P);
  if (name == "bookmark") {
    const std::optional<std::size_t> here = Here(now);
    if (!here) return Lines{say::NoPlaceHere()};
    return Lines{SetMark(*here, said.behind)};
  }
  if (name == "word" || name == "spell") {
    if (!near || !near->near) return Lines{say::NoWordHere()};
    return Lines{say::WordHere(near->word, name == "spell")};
  }
  if (name == "my text") return Lines{TakePassage(said.behind, now)};
  if (name == "find" && said.behind.empty() && near && near->near) {
    return Lines{FindWord(near->word, now)};
  }
  if (const auto command = PlaceCommandOf(name, said.behind)) {
    return Lines{Led(walk_->Go(*command, now))};
  }
  const std::size_t page = session_.felt().index;
  const bool turns = name == "next" ? page + 1 < session_.text().set.pages.size() : page > 0;
  if ((name == "next" || name == "back") && turns) coming_ = false;
  return std::nullopt;
}

/// Where the word at the tip stands next: so can look for it who types nothing.
std::string BookWalk::FindWord(const std::string& word, const LoopSnapshot& now) {
  const std::size_t here = LetterPlaceOf(session_.felt(), now.tip_P)->source;
  std::string refusal = walk_->Go({PlaceWord::kFind, word}, now);
  const std::optional<std::size_t> found = walk_->Going();
  const bool same = found && *found <= here && here < *found + word.size();
  if (refusal.empty() && same) refusal = walk_->Go({PlaceWord::kFindNext, ""}, now);
  return Led(std::move(refusal));
}

/// Of a way that was found reading goes on elsewhere; not of one that was refused.
std::string BookWalk::Led(std::string refusal) {
  if (refusal.empty()) coming_ = false;
  return refusal;
}

std::vector<std::string> BookWalk::Where(const LoopSnapshot& now) const {
  const std::optional<LetterPlace> here = LetterPlaceOf(session_.felt(), now.tip_P);
  const std::size_t letter = here ? here->source : letter_;
  // a line to be felt is short
  Lines lines{options_.moon ? PlaceInWords(letter)
                            : moontrace::Where(session_.felt(), session_.device().pushes(), now)};
  if (const TranscribedPage* page = PrintPageAt(book_.text, letter)) {
    lines.push_back(say::PrintedPage(page->name));
  }
  std::vector<std::string> headings;
  for (const std::size_t block : HeadingTrail(book_.document, BlockAt(book_.text, letter))) {
    headings.push_back(book_.document.blocks[block].text);
  }
  if (!headings.empty()) lines.push_back(say::BelowHeadings(headings));
  return lines;
}

std::string BookWalk::ToBlock(std::size_t block, std::string what, const LoopSnapshot& now,
                              bool note) {
  const std::optional<std::size_t> letter =
      block < book_.text.begins.size() ? LetterFrom(session_.text(), book_.text.begins[block])
                                       : std::nullopt;
  if (!letter) return say::NoPlaceHere();
  return Led(walk_->GoToPlace(*letter, std::move(what), now, note));
}

std::vector<std::string> BookWalk::Contents(const std::string& number, const LoopSnapshot& now) {
  const std::vector<ContentsEntry> contents = ContentsOf(book_.document);
  if (contents.empty()) return {say::NoContents()};
  if (!number.empty()) {
    std::size_t line = 0;
    const auto read = std::from_chars(number.data(), number.data() + number.size(), line);
    const bool whole = read.ec == std::errc() && read.ptr == number.data() + number.size();
    if (!whole || line < 1 || line > contents.size()) {
      return {say::NoSuchContents(number, contents.size())};
    }
    const ContentsEntry& entry = contents[line - 1];
    if (entry.block == kNoBlock) return {say::LeadsNowhere(entry.title)};
    return {ToBlock(entry.block, say::Followed(entry.title), now, false)};
  }
  return ListContents();
}

std::vector<std::string> BookWalk::ListContents() {
  const std::vector<ContentsEntry> contents = ContentsOf(book_.document);
  Lines lines;
  for (std::size_t i = 0; i < std::min(contents.size(), kMostContents); ++i) {
    const ContentsEntry& entry = contents[i];
    std::optional<FoundPlace> found;
    if (entry.block != kNoBlock) {
      const auto letter = LetterFrom(session_.text(), book_.text.begins[entry.block]);
      if (letter) found = Find(session_.text(), {*letter, kInLetter});
    }
    lines.push_back(say::NumberedContents(i + 1, entry, found ? found->page : 0));
    if (found) offer_.push_back({say::ShortTitle(entry.title), fmt::format("contents {}", i + 1)});
  }
  if (contents.size() > kMostContents) {
    lines.push_back(say::ContentsRest(contents.size() - kMostContents, contents.size()));
  }
  return lines;
}

std::vector<std::string> BookWalk::GoTo(const std::string& where, const LoopSnapshot& now) {
  const std::size_t pages = laid_.text().set.pages.size();
  if (where.empty()) return {say::GoToWhat(pages)};
  const std::string folded = CaseFolded(where);
  if (folded.rfind(kBookmark, 0) == 0) return {ToMark(where.substr(kBookmark.size()), now)};
  if (const std::optional<Lines> printed = ToPrintPage(where, now)) return *printed;
  const bool marked = memory_.MarkNamed(where) != nullptr;
  const bool page_told = !marked && folded.rfind(kPage, 0) == 0;
  const std::string page = say::Unstopped(where.substr(page_told ? kPage.size() : 0));
  const bool number = !page.empty() && page.find_first_not_of("0123456789") == std::string::npos;
  if (!number && !marked && memory_.MarkNamed(page) == nullptr) {
    return {say::NoSuchPlace(where, pages)};
  }
  if (!number) return {ToMark(marked ? where : page, now)};
  Lines lines{Led(walk_->Go({PlaceWord::kGoTo, page}, now))};
  if (marked) lines.push_back(say::MarkToo(where));
  return lines;
}

/// "print 7", with "go to" before it or without; none: something else.
std::optional<std::vector<std::string>> BookWalk::ToPrintPage(std::string_view line,
                                                              const LoopSnapshot& now) {
  constexpr std::string_view kPrint = "print ";
  const std::string given = WordsOf(line);
  const std::string folded = CaseFolded(given);
  if (folded.rfind(kPrint, 0) != 0) return std::nullopt;
  const std::string name = folded.substr(kPrint.size());
  for (const TranscribedPage& page : book_.text.pages) {
    if (CaseFolded(page.name) != name) continue;
    const auto letter = LetterFrom(session_.text(), page.begin);
    if (!letter) break;
    return Lines{Led(walk_->GoToPlace(*letter, say::PrintedPage(page.name), now))};
  }
  return Lines{say::NoSuchPrintPage(given.substr(kPrint.size()))};
}

std::vector<std::string> BookWalk::Follow(const LoopSnapshot& now) {
  const std::optional<std::size_t> here = Here(now);
  const TranscribedLink* link = here ? LinkAt(book_.text, *here) : nullptr;
  if (link == nullptr) return {say::NoLinkHere()};
  const DocumentMark& mark = book_.document.blocks[link->block].marks[link->mark];
  if (mark.missing) return {say::LeadsToNothing(mark.value)};
  if (mark.target == kNoBlock) return {say::LeadsOut(mark.value)};
  return {ToBlock(mark.target, say::Followed(book_.document.blocks[mark.target].text), now, true)};
}

/// Of bookmarks without a name the number will do.
std::string BookWalk::ToMark(const std::string& name, const LoopSnapshot& now) {
  const ReadMark* mark = memory_.MarkNamed(name);
  if (mark == nullptr && !name.empty()) mark = memory_.MarkNamed("mark " + name);
  if (mark == nullptr) return name.empty() ? say::NoMarks() : say::NoMarkNamed(name);
  return Led(
      walk_->GoToPlace(static_cast<std::size_t>(mark->place.letter), say::MarkIs(mark->name), now));
}

std::string BookWalk::SetMark(std::size_t letter, const std::string& name) {
  std::string from;
  const ReadMark* before = name.empty() ? nullptr : memory_.MarkNamed(name);
  if (before != nullptr) from = PlaceInWords(static_cast<std::size_t>(before->place.letter));
  const std::string given = memory_.Mark(book_.text.text, letter, name);
  const std::string place = PlaceInWords(letter);
  if (!KeepNow().empty() || !memory_.remembers()) return say::MarkForNow(given, place);
  return from.empty() || from == place ? say::MarkSet(given, place)
                                       : say::MarkMoved(given, from, place);
}

std::string BookWalk::ForgetMark(const std::string& name) {
  if (name.empty()) return say::ForgetWhat();
  const bool told = CaseFolded(name).rfind(kBookmark, 0) == 0;
  const std::string meant = told ? name.substr(kBookmark.size()) : name;
  if (!memory_.ForgetMark(meant)) return say::NoMarkNamed(meant);
  const std::string why = KeepNow();
  return why.empty() ? say::MarkForgotten(meant) : say::PlaceNotKept(why);
}

/// Of where reading goes on it is the line's start: there the place stays. Of any other the place
/// is it, wherever the hand still rests.
void BookWalk::Arrived(std::size_t source) {
  if (coming_) return;
  letter_ = source;
  coming_ = true;
  strays_ = 0;
}

std::string BookWalk::TakePassage(const std::string& given, const LoopSnapshot& now) {
  const std::optional<std::size_t> here = Here(now);
  if (given.empty() && !here) return say::NoPlaceHere();
  const std::string text = given.empty() ? SentenceAt(book_.text.text, *here) : given;
  if (!memory_.remembers()) return say::ReadsWithoutName();
  const std::string why = memory_.KeepOwnText(text);
  return why.empty() ? say::PassageTaken(text) : say::PlaceNotKept(why);
}

std::string BookWalk::Marked(const LetterPlace& place) { return SetMark(place.source, ""); }

std::vector<std::string> BookWalk::Bookmarks() {
  Lines lines;
  for (const ReadMark& mark : memory_.reading().marks) {
    offer_.push_back({say::ShortTitle(mark.name), "go to bookmark " + mark.name});
    lines.push_back(
        say::MarkLine(mark.name, PlaceInWords(static_cast<std::size_t>(mark.place.letter))));
  }
  if (lines.empty()) lines.push_back(say::NoMarks());
  return lines;
}

/// Where the hand is, as far as it has come to where reading goes on.
void BookWalk::See(const LoopSnapshot& now) {
  const FeltPage& felt = session_.felt();
  if (walk_ != nullptr && !coming_) letter_ = walk_->Going().value_or(letter_);
  if (now.page != felt.number) return;
  if (felt.index != kept_page_ && !coming_) {
    const std::vector<PlacedGlyph>& glyphs = felt.set().glyphs;
    const std::optional<FoundPlace> found = Find(session_.text(), {letter_, kInLetter});
    if (!glyphs.empty() && (!found || found->page != felt.index)) {
      letter_ = glyphs.front().source_begin;
    }
  }
  if (now.depth <= 0) return;
  const std::optional<LetterPlace> here = LetterPlaceOf(felt, now.tip_P);
  if (!here) return;
  if (coming_) {
    const std::optional<FoundPlace> found = Find(session_.text(), {letter_, kInLetter});
    const bool on_line =
        found && found->page == felt.index && found->line == LetterNear(felt, now.tip_P)->line;
    // from the line's start on; what was read of it stays read
    if (on_line && here->source < letter_) return;
    if (!on_line && ++strays_ < kMostStrays) return;
    coming_ = false;
  }
  letter_ = here->source;
}

/// A word that is left out, as its mark was come to: said, since it cannot be felt.
std::string BookWalk::Unset(const LoopSnapshot& now) {
  const FeltPage& felt = session_.felt();
  if (!options_.known || now.page != felt.number || now.depth <= 0) return {};
  const std::optional<LetterPlace> here = LetterPlaceOf(felt, now.tip_P);
  if (!here || !LetterNear(felt, now.tip_P)->near) return {};
  const std::vector<PlacedGlyph>& glyphs = felt.set().glyphs;
  const auto at = std::find_if(glyphs.begin(), glyphs.end(), [&here](const PlacedGlyph& glyph) {
    return glyph.source_begin == here->source;
  });
  if (at == glyphs.end() || word_ == std::pair(felt.index, at->word)) return {};
  word_ = {felt.index, at->word};
  const std::string words = UnsetWords(felt, static_cast<std::size_t>(at - glyphs.begin()));
  return words.empty() ? std::string() : say::NotSet(words);
}

std::string BookWalk::LineHere(const LoopSnapshot& now) const {
  const FeltPage& felt = session_.felt();
  if (laid_.lies() || now.page != felt.number || now.depth <= 0) return {};
  const std::optional<LetterPlace> here = LetterPlaceOf(felt, now.tip_P);
  if (!here) return {};
  const std::optional<FoundPlace> found = Find(session_.text(), *here);
  std::size_t begin = std::string::npos, end = 0;
  for (const PlacedGlyph& glyph : felt.set().glyphs) {
    if (!found || glyph.line != found->line) continue;
    begin = std::min(begin, glyph.source_begin);
    end = std::max(end, glyph.source_end);
  }
  if (begin >= end) return {};
  return say::LineFollowed(felt.index, session_.text().set.pages.size(), found->line,
                           WordsOf(std::string_view(felt.text->text).substr(begin, end - begin)));
}

bool BookWalk::BehindEnd(const LoopSnapshot& now) {
  const FeltPage& felt = session_.felt();
  if (!options_.alone || felt.set().glyphs.empty()) return false;
  const std::optional<LetterPlace> here = LetterPlaceOf(felt, now.tip_P);
  const bool on_last = now.depth > 0 && here->source == felt.set().glyphs.back().source_begin &&
                       LetterNear(felt, now.tip_P)->near;
  const bool left = !on_last && last_touched_;
  last_touched_ = on_last;
  return left;
}

/// Not where the page before was turned: the tip still lies there, on the next page's mark.
bool BookWalk::OnTurnMark(const LoopSnapshot& now) {
  if (!options_.turns || now.depth <= 0) return false;
  const Box mark_P = TurnMark(session_.text().set.page).box_P;
  if (!Contains(mark_P, glm::dvec2(now.tip_P))) {
    beside_mark_ = now.page;
    return false;
  }
  return beside_mark_ == now.page;
}

std::vector<std::string> BookWalk::TurnPage(const LoopSnapshot& now) {
  if (now.page != session_.felt().number || (!BehindEnd(now) && !OnTurnMark(now))) return {};
  beside_mark_.reset();
  coming_ = false;  // the reader goes on from here, wherever reading was to go on
  const std::size_t pages = session_.text().set.pages.size();
  trembles_ = session_.Turn(true);
  if (trembles_) return {say::NowPage(session_.felt().index, pages)};
  ended_ = options_.alone;
  return {say::TheEnd()};
}

/// Why not, where that fails.
std::string BookWalk::KeepNow() {
  kept_ = letter_;
  kept_page_ = session_.felt().index;
  kept_at_ = std::chrono::steady_clock::now();
  return memory_.Keep(book_.text.text, letter_, PlaceInWords(letter_));
}

std::string BookWalk::Keep() {
  const std::string why = KeepNow();
  if (why.empty()) return {};
  return std::exchange(told_failure_, true) ? std::string() : say::PlaceNotKept(why);
}

bool BookWalk::Answered(const std::vector<std::string>& lines, const LoopSnapshot& now) {
  std::vector<LaidLines::Line> laid = std::exchange(offer_, {});
  // without force nothing could be felt: a stop is no answer
  if (!options_.moon || now.stopped) return false;
  if (laid.empty()) {
    for (const std::string& line : lines) laid.push_back({line, ""});
  }
  return laid_.Lay(std::move(laid), now.tip_P);
}

bool BookWalk::ClearPage() {
  opening_.lines.clear();  // likewise who says a word
  return laid_.Clear();
}

/// Without force a press brings it back: who reads by touch alone could find no word for it.
Companion::Press BookWalk::Pressed(bool twice, const LoopEvent& event) {
  if (!options_.moon) return {};
  opening_.lines.clear();  // who presses knows what the button does
  if (was_stopped_) {
    session_.GoOn();
    return {true, ""};
  }
  if (laid_.lies()) {
    LaidLines::Press press = laid_.Pressed(twice, event.tip_P);
    turned_lines_ = turned_lines_ || press.turned;
    return {true, std::move(press.word)};
  }
  if (!twice) return {true, "where"};
  std::vector<LaidLines::Line> menu;
  for (const std::string& word : say::MoonMenu()) menu.push_back({word, word});
  turned_lines_ = laid_.Lay(std::move(menu), event.tip_P);
  return {true, ""};
}

std::vector<std::string> BookWalk::Look(const LoopSnapshot& now) {
  urgent_ = false;
  trembles_ = std::exchange(turned_lines_, false);
  const bool stopped = now.stopped && !was_stopped_;
  was_stopped_ = now.stopped;
  if (laid_.lies()) return {};
  if (!opening_.lines.empty()) {
    if (now.depth > 0) {
      trembles_ = laid_.Lay(std::exchange(opening_.lines, {}), opening_.at_P);
    }
    return {};
  }
  See(now);
  Lines lines = TurnPage(now);
  if (std::string unset = Unset(now); !unset.empty()) lines.push_back(std::move(unset));
  const bool page = session_.felt().index != kept_page_ && now.page == session_.felt().number;
  const bool moved = kept_ != letter_;
  const bool due = std::chrono::steady_clock::now() - kept_at_ >= kKeptEvery;
  urgent_ = std::find(lines.begin(), lines.end(), say::TheEnd()) != lines.end();
  if (page || stopped || (moved && due)) {
    lines.push_back(Keep());
    urgent_ = urgent_ || !lines.back().empty();
  }
  return lines;
}

std::vector<std::string> BookWalk::End() {
  const std::string why = KeepNow();
  lost_ = !why.empty();
  if (lost_ && told_failure_) return {};
  if (lost_) return {say::PlaceNotKept(why)};
  if (!memory_.remembers()) return {};
  return {say::PlaceKept(PlaceInWords(letter_))};
}

}  // namespace moontrace
