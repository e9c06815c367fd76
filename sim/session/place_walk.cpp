#include "sim/session/place_walk.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <glm/geometric.hpp>
#include <string>
#include <utility>
#include <vector>

#include "sim/session/place_messages.h"
#include "textures/base/utf8.h"
#include "textures/typeset/fold.h"
#include "textures/typeset/structure.h"

namespace moontrace {

namespace {

/// Of a letter, where a hand finds it: a little inside, half way up [em].
constexpr glm::dvec2 kInLetter{0.25, 0.5};
constexpr double kLedAt = 0.04;       ///< [m/s], as a calm hand goes from line to line; ours
constexpr double kShortestWay = 0.5;  ///< [s]
/// A hand within a letter's height of a way has not left it: it rests, or is on its way. Ours.
constexpr double kBesideWay = 1;  ///< [em]
/// A hand as near as this to the letter that was gone to has come, and rests there. Ours.
constexpr double kAtPlace = 0.5;  ///< [em]

bool IsBlank(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }

/// A text made ready for comparing, and the byte in the text for each of its own.
struct Comparable {
  std::string text;
  std::vector<std::size_t> sources;
};

Comparable ComparableOf(std::string_view text) {
  Comparable made;
  for (std::size_t i = 0; i < text.size();) {
    char32_t c = 0;
    const std::size_t length = std::max<std::size_t>(1, Decode(text.substr(i), c));
    std::string folded(text.substr(i, length));
    if (IsBlank(text[i])) {
      folded = made.text.empty() || made.text.back() == ' ' ? "" : " ";
    } else if (length > 1 || (text[i] >= 'A' && text[i] <= 'Z')) {
      folded = CaseFolded(folded);
    }
    made.text += folded;
    made.sources.insert(made.sources.end(), folded.size(), i);
    i += length;
  }
  return made;
}

/// A letter that stands on a page of a text.
struct Standing {
  std::size_t page = 0;
  const PlacedGlyph* glyph = nullptr;
};

/// The first letter of a row behind (`page`, `line`) for which `fits` holds; a running head is no
/// row of the text.
template <typename Fits>
std::optional<Standing> RowBehind(const TextSetup& text, std::size_t page, std::size_t line,
                                  Fits fits) {
  for (std::size_t at = page; at < text.set.pages.size(); ++at) {
    for (const PlacedGlyph& glyph : text.set.pages[at].glyphs) {
      const bool behind = at > page || glyph.line > line;
      if (behind && glyph.kind != LineKind::kHead && fits(glyph)) return Standing{at, &glyph};
    }
  }
  return std::nullopt;
}

double DistanceToWay(glm::dvec2 p, glm::dvec2 from, glm::dvec2 to) {
  const glm::dvec2 way = to - from;
  const double square = glm::dot(way, way);
  const double share = square > 0 ? std::clamp(glm::dot(p - from, way) / square, 0.0, 1.0) : 0;
  return glm::distance(p, from + share * way);
}

/// The line of the source that a byte stands in, as it is read: without its marks of structure.
std::string LineAround(const TextSetup& setup, std::size_t source) {
  const std::string_view text = setup.text;
  const std::size_t end = std::min(text.find('\n', source), text.size());
  const std::size_t begin = text.rfind('\n', source);
  const std::size_t first = begin == std::string_view::npos || begin > source ? 0 : begin + 1;
  const std::string_view line = text.substr(first, end - first);
  if (!setup.set.style.structure.read) return std::string(line);
  std::vector<FoldedChar> characters;
  for (std::size_t i = 0; i < line.size();) {
    FoldedChar one;
    one.begin = static_cast<std::uint32_t>(i);
    i += std::max<std::size_t>(1, Decode(line.substr(i), one.code));
    one.end = static_cast<std::uint32_t>(i);
    if (one.code == ' ') one.kind = FoldedChar::Kind::kSpace;
    characters.push_back(one);
  }
  TakeMarks(line, characters);
  std::string read;
  for (const FoldedChar& one : characters) read += line.substr(one.begin, one.end - one.begin);
  return read;
}

}  // namespace

std::optional<PlaceCommand> PlaceCommandOf(std::string_view word, std::string_view behind) {
  constexpr std::array<std::string_view, 8> kWords = {"find",      "find next",    "return",
                                                      "next line", "next heading", "next paragraph",
                                                      "next link", "go to"};
  const auto found = std::find(kWords.begin(), kWords.end(), word);
  if (found == kWords.end()) return std::nullopt;
  return PlaceCommand{static_cast<PlaceWord>(found - kWords.begin()), std::string(behind)};
}

std::vector<std::size_t> Occurrences(std::string_view text, std::string_view wanted) {
  std::vector<std::size_t> found;
  std::string sought = ComparableOf(wanted).text;
  while (!sought.empty() && sought.back() == ' ') sought.pop_back();
  if (sought.empty()) return found;
  const Comparable all = ComparableOf(text);
  std::size_t at = all.text.find(sought);
  for (; at != std::string::npos; at = all.text.find(sought, at + sought.size())) {
    found.push_back(all.sources[at]);
  }
  return found;
}

PlaceWalk::PlaceWalk(const LoopSession& session, Turn turn)
    : session_(session), turn_(std::move(turn)) {}

void PlaceWalk::ForgetOtherText() {
  const std::string& text = session_.text().text;
  if (text == text_) return;
  text_ = text;
  wanted_.clear();
  found_.clear();
  before_.clear();
  returned_ = false;
  target_.reset();
  way_.reset();
}

std::string PlaceWalk::Go(const PlaceCommand& command, const LoopSnapshot& now) {
  ForgetOtherText();
  const std::optional<LetterPlace> here = LetterPlaceOf(session_.felt(), now.tip_P);
  if (!here || session_.felt().blank) return say::NoPlaceHere();
  const bool leaves = command.word != PlaceWord::kReturn && command.word != PlaceWord::kNextLine;
  const bool first = leaves && before_.empty();
  if (first) before_.push_back(*here);
  std::string refusal = Lead(command, here->source, now);
  if (first && !refusal.empty()) before_.pop_back();  // the hand has gone nowhere
  if (leaves && refusal.empty()) returned_ = false;
  return refusal;
}

std::string PlaceWalk::Lead(const PlaceCommand& command, std::size_t here,
                            const LoopSnapshot& now) {
  switch (command.word) {
    case PlaceWord::kFind:
      return Find(command.text, here);
    case PlaceWord::kFindNext:
      return FindNext();
    case PlaceWord::kReturn:
      return Return();
    case PlaceWord::kNextLine:
      return NextRow(false, now);
    case PlaceWord::kNextHeading:
      return NextRow(true, now);
    case PlaceWord::kNextParagraph:
      return NextParagraph(now);
    case PlaceWord::kNextLink:
      return NextLink(now);
    case PlaceWord::kGoTo:
      return GoToPage(command.text);
  }
  return {};
}

std::string PlaceWalk::GoToPlace(std::size_t source, std::string what, const LoopSnapshot& now,
                                 bool from) {
  ForgetOtherText();
  const std::optional<LetterPlace> here = LetterPlaceOf(session_.felt(), now.tip_P);
  if (!here || session_.felt().blank) return say::NoPlaceHere();
  if (from || before_.empty()) before_.push_back(from ? *Here(now) : *here);
  returned_ = false;
  return GoTo({{source, kInLetter}, std::move(what)});
}

std::string PlaceWalk::Begin(std::size_t source, std::string what) {
  ForgetOtherText();
  return GoTo({{source, kInLetter}, std::move(what), true});
}

std::string PlaceWalk::Find(const std::string& wanted, std::size_t here) {
  if (wanted.empty()) return say::FindWhat();
  std::vector<std::size_t> found = Occurrences(text_, wanted);
  if (found.empty()) return say::NotInText(wanted);
  found_ = std::move(found);
  wanted_ = wanted;
  const auto first = std::lower_bound(found_.begin(), found_.end(), here);
  at_ = first == found_.end() ? 0 : static_cast<std::size_t>(first - found_.begin());
  return GoTo({{found_[at_], kInLetter}, say::Occurrence(wanted_, at_ + 1, found_.size())});
}

std::string PlaceWalk::FindNext() {
  if (found_.empty()) return say::FindWhat();
  at_ = (at_ + 1) % found_.size();
  return GoTo({{found_[at_], kInLetter}, say::Occurrence(wanted_, at_ + 1, found_.size())});
}

std::string PlaceWalk::Return() {
  if (before_.empty()) return returned_ ? say::BackAlready() : say::NowhereToReturn();
  const LetterPlace place = before_.back();
  before_.pop_back();
  returned_ = true;
  const auto found = moontrace::Find(session_.text(), place);
  return GoTo({place, say::BackAt(found ? found->letter : "")});
}

/// Where a next row is counted from: the place gone to last, as long as the hand is not elsewhere,
/// so that a word said again leads on.
LetterPlace PlaceWalk::StartOf(const LoopSnapshot& now) const {
  if (target_) return target_->place;
  const bool same_page = way_ && way_->page == session_.felt().index;
  const double reach = kBesideWay * session_.text().set.style.size;
  const bool on_way =
      same_page && (session_.device().simulated() ||  // the program's hand goes its own way
                    DistanceToWay(now.tip_P, way_->tip_P, way_->place_P) <= reach);
  return on_way ? way_->to : *LetterPlaceOf(session_.felt(), now.tip_P);
}

std::optional<LetterPlace> PlaceWalk::Here(const LoopSnapshot& now) {
  ForgetOtherText();
  const std::optional<LetterPlace> hand = LetterPlaceOf(session_.felt(), now.tip_P);
  if (!hand) return std::nullopt;
  const double reach = kAtPlace * session_.text().set.style.size;
  const bool gone =
      way_ && way_->come && glm::distance(glm::dvec2(now.tip_P), way_->place_P) > reach;
  return target_ || !gone ? StartOf(now) : *hand;
}

std::string PlaceWalk::NextRow(bool heading, const LoopSnapshot& now) {
  const LetterPlace start = StartOf(now);
  const std::size_t here = start.source;
  const auto from = moontrace::Find(session_.text(), start);
  if (!from) return say::NoPlaceHere();
  const auto fits = [&](const PlacedGlyph& glyph) {
    if (!heading) return true;
    // a heading of two rows is one
    const std::size_t length = glyph.source_begin - std::min(here, glyph.source_begin);
    return glyph.kind == LineKind::kHeading &&
           std::string_view(text_).substr(here, length).find('\n') != std::string_view::npos;
  };
  const auto row = RowBehind(session_.text(), from->page, from->line, fits);
  if (!row) return heading ? say::NoHeadingBehind() : say::NoLineBehind();
  const std::size_t source = row->glyph->source_begin;
  return GoTo(
      {{source, kInLetter}, heading ? say::HeadingIs(LineAround(session_.text(), source)) : ""});
}

/// Paragraphs have a blank line between them.
std::string PlaceWalk::NextParagraph(const LoopSnapshot& now) {
  std::size_t begin = StartOf(now).source;
  do {
    begin = text_.find('\n', begin);
    if (begin == std::string::npos) return say::NoParagraphBehind();
    begin = text_.find_first_not_of(" \t\r", begin + 1);
    if (begin == std::string::npos) return say::NoParagraphBehind();
  } while (text_[begin] != '\n');
  begin = text_.find_first_not_of(" \t\r\n", begin);
  if (begin == std::string::npos) return say::NoParagraphBehind();
  const std::optional<std::size_t> letter = LetterFrom(session_.text(), begin);  // behind its mark
  if (!letter) return say::NoParagraphBehind();
  return GoTo({{*letter, kInLetter}, say::ParagraphIs(LineAround(session_.text(), *letter))});
}

std::string PlaceWalk::NextLink(const LoopSnapshot& now) {
  const TextSetup& text = session_.text();
  const LetterPlace start = StartOf(now);
  const std::size_t here = start.source;
  const auto from = moontrace::Find(text, start);
  if (!from) return say::NoPlaceHere();
  bool in_link = false;
  std::size_t end = 0;  // of the link's letter before
  for (std::size_t page = from->page; page < text.set.pages.size(); ++page) {
    for (const PlacedGlyph& glyph : text.set.pages[page].glyphs) {
      if (glyph.kind == LineKind::kHead) continue;
      const bool same = in_link && glyph.link && end <= glyph.source_begin &&
                        std::string_view(text_).substr(end, glyph.source_begin - end).find("](") ==
                            std::string_view::npos;
      if (glyph.link && !same && glyph.source_begin > here) {
        const std::string_view words = std::string_view(text_).substr(glyph.source_begin);
        return GoTo(
            {{glyph.source_begin, kInLetter}, say::LinkIs(words.substr(0, words.find(']')))});
      }
      in_link = glyph.link;
      end = glyph.source_end;
    }
  }
  return say::NoLinkBehind();
}

std::string PlaceWalk::GoToPage(const std::string& number) {
  const std::vector<TextPage>& pages = session_.text().set.pages;
  std::size_t page = 0;
  const auto read = std::from_chars(number.data(), number.data() + number.size(), page);
  if (read.ec != std::errc() || read.ptr != number.data() + number.size() || page < 1 ||
      page > pages.size()) {
    return say::NoSuchPage(number, pages.size());
  }
  const std::vector<PlacedGlyph>& glyphs = pages[page - 1].glyphs;
  if (glyphs.empty()) return say::NoPlaceHere();
  return GoTo({{glyphs.front().source_begin, kInLetter}, ""});
}

std::string PlaceWalk::GoTo(Target target) {
  const auto found = moontrace::Find(session_.text(), target.place);
  if (!found) return say::NoPlaceHere();
  if (found->page != session_.felt().index) turn_(found->page);
  target_ = std::move(target);
  return {};
}

std::optional<PlaceWalk::Arrival> PlaceWalk::Arrived(const LoopSnapshot& now) {
  if (way_ && glm::distance(glm::dvec2(now.tip_P), way_->place_P) <=
                  kAtPlace * session_.text().set.style.size) {
    way_->come = true;
  }
  if (!target_ || now.page != session_.felt().number) return std::nullopt;
  const Target target = *std::exchange(target_, std::nullopt);
  const auto found = moontrace::Find(session_.text(), target.place);
  if (session_.text().text != text_ || !found) return std::nullopt;
  way_ = {target.place, found->page, glm::dvec2(now.tip_P), found->p_P, false};
  // the simulated hand goes its own way: from where it is now says nothing
  std::optional<glm::dvec2> way_P;
  if (!session_.device().simulated()) way_P = found->p_P - glm::dvec2(now.tip_P);
  const std::size_t pages = session_.text().set.pages.size();
  return Arrival{say::PlaceIs(target.what, found->page, pages, found->line, way_P),
                 target.place.source, now.tip_P, found->p_P};
}

std::shared_ptr<const GuidancePath> PathTo(const PlaceWalk::Arrival& arrival, double width) {
  const double way = glm::length(arrival.place_P - glm::dvec2(arrival.tip_P));
  return MakeRecordedPath({0, std::max(kShortestWay, way / kLedAt)},
                          {arrival.tip_P, glm::dvec3(arrival.place_P, arrival.tip_P.z)}, width);
}

}  // namespace moontrace
