#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "textures/base/error.h"
#include "textures/base/units.h"
#include "textures/typeset/layout.h"

// How signs fill rows, and where a row ends.

namespace moontrace {

// A chunk is what no line ends within if it holds it: up to a space at which a line may end, or
// behind a hyphen.
std::size_t Layout::ChunkEnd(const std::vector<Sign>& signs, std::size_t at) const {
  while (at < signs.size() && !(signs[at].space && !signs[at].keep_next)) {
    const Sign& sign = signs[at++];
    if (sign.break_after && !sign.keep_next) break;
  }
  return at;
}

bool Layout::Fits(const std::vector<Sign>& signs, std::size_t at, std::size_t end,
                  double pen) const {
  for (; at < end; ++at) {
    if (pen + ExtentOf(signs[at]) > line_length_ + kSlack) return false;
    pen += AdvanceOf(signs[at]);
  }
  return true;
}

void Layout::Place(const std::vector<Sign>& signs, std::size_t at) {
  const Sign& sign = signs[at];
  if (!Fits(signs, at, at + 1, pen_)) {
    throw InputError(fmt::format(
        "lines are {:.4g} mm {}, the letter '{}' needs {:.4g} mm: choose smaller letters",
        InMillimetres(line_length_), direction_ == LineDirection::kVertical ? "high" : "wide",
        script_.glyphs[sign.glyph].name, InMillimetres(Row().extent[sign.glyph])));
  }
  Put(sign);
}

bool Layout::MayEnd(const Sign& sign, Break how) {
  switch (how) {
    case Break::kPattern:
      return sign.hyphen_after && !sign.keep_next;
    case Break::kAtSpace:
      return sign.space && !sign.bound;
    case Break::kBehindMark:
      return sign.mark && !sign.keep_next;
    case Break::kKeepingMarks:
      return !sign.keep_next;
    case Break::kKeepingGroups:
      return !sign.bound;
    case Break::kAnywhere:
      return true;
  }
  return true;
}

bool Layout::NeedsHyphen(const Sign& last, const Sign& next) const {
  return hyphen_ && !last.keep_next && !last.mark && !next.mark;
}

// The end of the longest part of a chunk that the row holds, if `hyphenated` with a hyphen where
// one is needed; `at` if there is none. With hyphens a single letter is not left over where two can
// be.
std::size_t Layout::PartEnd(const std::vector<Sign>& signs, std::size_t at, std::size_t end,
                            Break how, bool hyphenated) const {
  std::size_t best = at, before_best = at, places = 0;
  double pen = pen_;
  for (std::size_t i = at; i + 1 < end; ++i) {
    if (pen + ExtentOf(signs[i]) > line_length_ + kSlack) break;
    pen += AdvanceOf(signs[i]);
    if (!MayEnd(signs[i], how)) continue;
    if (hyphenated && NeedsHyphen(signs[i], signs[i + 1]) &&
        pen + Row().extent[hyphen_->glyph] > line_length_ + kSlack) {
      continue;
    }
    before_best = best;
    best = i + 1;
    ++places;
  }
  if (!hyphen_ || how != Break::kKeepingMarks || places < 3) return best;
  for (std::size_t i = best; i + 1 < end; ++i) {
    if (MayEnd(signs[i], how)) return best;
  }
  return before_best;
}

// Whether an empty row holds what begins at `at`, up to where it may end.
bool Layout::HoldsUnit(const std::vector<Sign>& signs, std::size_t at, std::size_t end,
                       Break how) const {
  double pen = indent_;
  for (; at < end; ++at) {
    if (pen + ExtentOf(signs[at]) > line_length_ + kSlack) return false;
    if (MayEnd(signs[at], how)) return true;
    pen += AdvanceOf(signs[at]);
  }
  return true;
}

// The same on an empty row that does not hold the chunk, nor a part that patterns allow: as much as
// fits. A hyphen is left out where a single sign would stand beside it and two can without.
std::size_t Layout::ForcedEnd(const std::vector<Sign>& signs, std::size_t at,
                              std::size_t end) const {
  for (const Break how : {Break::kAtSpace, Break::kBehindMark, Break::kKeepingMarks,
                          Break::kKeepingGroups, Break::kAnywhere}) {
    std::size_t part = PartEnd(signs, at, end, how, true);
    if (part <= at + 1) part = PartEnd(signs, at, end, how, false);
    // what no row keeps together does not leave this one half empty
    const bool in_vain = how == Break::kKeepingMarks && !HoldsUnit(signs, part, end, how);
    if (part > at && !in_vain) return part;
  }
  return at + 1;
}

// The end of what goes on the row of a chunk; `at` for nothing. Once a word was broken elsewhere
// (`forced`) its rows are filled: patterns would leave stubs.
std::size_t Layout::PartEnd(const std::vector<Sign>& signs, std::size_t at, std::size_t end,
                            bool forced) const {
  if (Fits(signs, at, end, pen_)) return end;
  const bool behind_hyphen = !row_empty_ && at > 0 && signs[at - 1].break_after;
  if (hyphen_ && !forced && !(behind_hyphen && Fits(signs, at, end, indent_))) {
    const std::size_t part = PartEnd(signs, at, end, Break::kPattern, true);
    if (part > at) return part;
  }
  return row_empty_ && pen_ <= text_start_ ? ForcedEnd(signs, at, end) : at;
}

// Ends a row within a word.
void Layout::BreakRow(const Sign& last, const Sign& next) {
  if (NeedsHyphen(last, next) && pen_ + Row().extent[hyphen_->glyph] <= line_length_ + kSlack) {
    Sign hyphen = *hyphen_;
    hyphen.begin = hyphen.end = last.end;
    Put(hyphen);
    pages_.back().glyphs.back().bridge = true;
  }
  StartRow();
  RepeatNumeral(next);
}

// A row that begins within a number begins with its numeral sign, where that leaves room.
void Layout::RepeatNumeral(const Sign& digit) {
  if (!digit.in_number || numeral_ == Script::npos) return;
  const double begin = pen_ + Row().advance[numeral_];
  if (begin + Row().extent[digit.glyph] > line_length_ + kSlack) return;
  Sign numeral;
  numeral.glyph = static_cast<std::uint32_t>(numeral_);
  numeral.begin = numeral.end = digit.begin;
  numeral.link = digit.link;
  Put(numeral);
  text_start_ = pen_;
  row_empty_ = true;
}

// On a row that has room; `new_word`: it begins one.
void Layout::AddSign(const std::vector<Sign>& signs, std::size_t at, bool& new_word) {
  if (signs[at].space) {
    pen_ += Row().space;
    new_word = true;
    return;
  }
  if (std::exchange(new_word, false)) ++words_;
  Place(signs, at);
}

void Layout::AddWrapped(const std::vector<Sign>& signs) {
  bool new_word = true;
  for (std::size_t at = 0; at < signs.size();) {
    if (signs[at].space) {
      AddSign(signs, at++, new_word);
      continue;
    }
    const std::size_t end = ChunkEnd(signs, at);
    bool forced = false;
    while (at < end) {
      const std::size_t part = PartEnd(signs, at, end, forced);
      if (part == at) {
        if (!row_empty_) StartRow();
        pen_ = text_start_;  // spaces at the wrap, or an indent that leaves no room
        continue;
      }
      for (; at < part; ++at) AddSign(signs, at, new_word);
      if (part == end) break;
      const Sign& last = signs[part - 1];
      forced = forced || !(last.hyphen_after || last.mark || last.space);
      BreakRow(last, signs[part]);
      while (at < end && signs[at].space) ++at;  // none begins a row
    }
  }
}

// From the strokes of a line's last sign to its guide: the usual gap, and behind a finished word
// the space too.
double Layout::ClosingGap(std::size_t glyph, bool finished) const {
  return Row().advance[glyph] - Row().extent[glyph] + (finished ? Row().space : 0);
}

// Whether a sign that stands at `pen` fits on the row with its guide behind it.
bool Layout::FitsBeforeGuide(const std::vector<Sign>& signs, std::size_t at, double pen) const {
  const bool finished = at + 1 == signs.size() || signs[at + 1].space;
  const std::size_t glyph = signs[at].glyph;
  return pen + Row().extent[glyph] + ClosingGap(glyph, finished) + Row().bulge <=
         line_length_ + kSlack;
}

// Whether a running row has no room for a sign, with those that stay on its line: up to a third of
// the line, since what is longer might find no row.
bool Layout::MustWrap(const std::vector<Sign>& signs, std::size_t at) const {
  double pen = pen_;
  std::size_t last = at;
  while (signs[last].keep_next && last + 1 < signs.size() && !signs[last + 1].space) {
    if (last > at && pen - pen_ > line_length_ / 3) break;
    pen += Row().advance[signs[last++].glyph];
  }
  return !FitsBeforeGuide(signs, last, pen);
}

// Ends a running row behind the sign that was set last, with a guide to the next.
void Layout::Wrap(const Sign& last) {
  const bool finished = last.space;
  const PlacedGlyph end = pages_.back().glyphs.back();
  const double gap = ClosingGap(end.glyph, finished);
  // What was added behind the last sign (its own gap, spaces) is not counted.
  const glm::dvec2 origin = end.origin_P;
  const double reached = RunsBack() ? page_.width - page_.margin - origin.x
                                    : origin.x + Row().right[end.glyph] - page_.margin;
  const double guide = reached + gap;  // from the row's start
  const std::size_t glyph = RunsBack() ? guide_left_ : guide_right_;
  PlacedGlyph placed = end;
  placed.glyph = glyph;
  placed.source_begin = placed.source_end;
  placed.link = false;
  placed.bridge = true;
  placed.origin_P = {RunsBack() ? page_.width - page_.margin - guide : page_.margin + guide,
                     origin.y};
  if (glyph != Script::npos) pages_.back().glyphs.push_back(placed);
  StartRow();
  const bool new_page =
      std::all_of(pages_.back().glyphs.begin(), pages_.back().glyphs.end(),
                  [](const PlacedGlyph& placed_one) { return placed_one.kind == LineKind::kHead; });
  if (new_page) {  // no line follows on that page
    if (glyph != Script::npos) pages_[pages_.size() - 2].glyphs.pop_back();
    return;
  }
  pen_ = line_length_ - guide + gap;
}

void Layout::BeginRunning() {
  const bool own_row = kind_ == LineKind::kHeading || kind_ != kind_before_;
  if (own_row) run_row_ = next_row_;
  if (pages_.empty() || own_row) StartRow();
  if (!row_empty_) pen_ += paragraph_gap_;
  paragraph_ended_ = false;
}

void Layout::AddRunning(const std::vector<Sign>& signs) {
  bool new_word = true;
  const Sign* before = nullptr;
  for (std::size_t at = 0; at < signs.size(); ++at) {
    const Sign& sign = signs[at];
    if (sign.space) {
      if (!row_empty_) pen_ += Row().space;
      new_word = true;
    } else {
      Sign end;
      end.space = before == nullptr || before->space;
      if (!row_empty_ && MustWrap(signs, at)) {
        Wrap(end);
        // A line too short to begin under its guide begins at the margin.
        const bool parted = sign.bound && MustWrap(signs, at);
        if (parted || !Fits(signs, at, at + 1, pen_)) pen_ = 0;
        RepeatNumeral(sign);
      }
      if (new_word) ++words_;
      new_word = false;
      Place(signs, at);
    }
    before = &sign;
  }
}

}  // namespace moontrace
