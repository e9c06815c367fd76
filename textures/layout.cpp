#include "textures/layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "textures/error.h"

namespace moontrace {
namespace {

constexpr double kSlack = 1e-9;        // a line that fits but for rounding fits [m]
constexpr double kGuideBulge = 0.3;    // of the line pitch
constexpr double kGuideAdvance = 0.9;  // [em]; nothing follows a guide on its line

double Mm(double metres) { return metres * 1000; }

Box BoundsOf(const Glyph& glyph) {
  Box box{{0, 0}, {0, 0}};
  for (const Stroke& stroke : glyph.strokes) {
    for (const Piece& piece : stroke.pieces) Include(box, moontrace::BoundsOf(piece));
  }
  return box;
}

// The middle of the lowest stroke or dot, below which only its own width lies [em].
double LowestMiddle(const Glyph& glyph) {
  double lowest = 0;
  for (const Stroke& stroke : glyph.strokes) {
    for (const Piece& piece : stroke.pieces) {
      const Box box = moontrace::BoundsOf(piece);
      const bool dot = stroke.kind == StrokeKind::kDot;
      lowest = std::min(lowest, dot ? (box.min.y + box.max.y) / 2 : box.min.y);
    }
  }
  return lowest;
}

}  // namespace

void AddGuides(Script& script, const TypeStyle& style) {
  const double pitch = style.line_pitch / style.size;  // [em]
  const double bulge = kGuideBulge * pitch;
  const double radius = (pitch * pitch / 4 + bulge * bulge) / (2 * bulge);
  const double half = std::asin(pitch / 2 / radius);
  const auto add = [&script](const char* name, const Arc& arc) {
    Glyph guide{name, kGuideAdvance, {{StrokeKind::kStroke, {arc}}}};
    const std::size_t old = script.Find(name);
    if (old == Script::npos) {
      script.glyphs.push_back(std::move(guide));
    } else {
      script.glyphs[old] = std::move(guide);
    }
  };
  const double middle = 0.5 - pitch / 2;
  add("guide-right", {{bulge - radius, middle}, radius, half, -2 * half});
  add("guide-left", {{radius - bulge, middle}, radius, std::acos(-1.0) - half, 2 * half});
}

Layout::Layout(const Script& script, const TypeStyle& style, const PageSpec& page)
    : script_(script),
      direction_(style.lines),
      page_(page),
      size_(style.size),
      space_(script.space_advance * style.size + style.word_gap),
      line_pitch_(style.line_pitch) {
  const bool vertical = direction_ == LineDirection::kVertical;
  line_length_ = (vertical ? page.height : page.width) - 2 * page.margin;
  const double across = (vertical ? page.width : page.height) - 2 * page.margin;
  room_ = across - size_ + kSlack;
  if (room_ < 0) {
    throw InputError(
        fmt::format("the page has {:.4g} mm between its margins, a line needs {:.4g} "
                    "mm: choose smaller letters or a larger page",
                    Mm(across), Mm(size_)));
  }
  empty_rows_ = !style.paragraph_gap;
  paragraph_gap_ = style.paragraph_gap.value_or(Alternates() ? 2 * space_ : line_pitch_);
  for (const Glyph& glyph : script.glyphs) {
    const Box bounds = BoundsOf(glyph);
    right_.push_back(bounds.max.x * size_);
    lowest_.push_back(LowestMiddle(glyph) * size_);
    const double advance = glyph.advance * size_ + style.letter_gap;
    // Down a column each sign has its whole box, and below it the gap that it has along a line.
    extent_.push_back(vertical ? size_ : right_.back());
    advance_.push_back(vertical ? size_ + std::max(advance - right_.back(), 0.0) : advance);
  }
  if (Alternates()) {
    guide_right_ = script.Find("guide-right");
    guide_left_ = script.Find("guide-left");
    bulge_ = kGuideBulge * line_pitch_;
  }
}

// Whether the row that is being set runs right to left.
bool Layout::RunsBack() const {
  if (direction_ == LineDirection::kRightToLeft) return true;
  return Alternates() && next_row_ % 2 == 0;
}

void Layout::EndParagraph() { paragraph_ended_ = true; }

void Layout::StartRow() {
  if (paragraph_ended_ && !pages_.empty() && !Alternates()) {
    if (empty_rows_) {
      ++next_row_;
    } else {
      gaps_ += paragraph_gap_;
    }
  }
  paragraph_ended_ = false;
  const double used = static_cast<double>(next_row_) * line_pitch_ + gaps_;
  if (pages_.empty() || used > room_) {
    const std::size_t expected = pages_.empty() ? 0 : pages_.back().glyphs.size();
    pages_.emplace_back();
    pages_.back().glyphs.reserve(expected);
    next_row_ = 0;
    gaps_ = 0;
  }
  pages_.back().lines = ++next_row_;
  pen_ = 0;
  row_empty_ = true;
}

// A chunk is what no line may end within: up to a space or behind a hyphen.
std::size_t Layout::ChunkEnd(const std::vector<Sign>& signs, std::size_t at) const {
  while (at < signs.size() && !signs[at].space) {
    if (signs[at++].break_after) break;
  }
  return at;
}

bool Layout::Fits(const std::vector<Sign>& signs, std::size_t at, std::size_t end,
                  double pen) const {
  for (; at < end; ++at) {
    if (pen + extent_[signs[at].glyph] > line_length_ + kSlack) return false;
    pen += advance_[signs[at].glyph];
  }
  return true;
}

// Where a glyph stands whose start is `pen` from the start of the current row.
glm::dvec2 Layout::OriginOf(std::size_t glyph, double pen) const {
  const double across = static_cast<double>(next_row_ - 1) * line_pitch_ + gaps_;
  if (direction_ == LineDirection::kVertical) {
    const double column = page_.width - page_.margin - size_ - across;
    return {column + (size_ - right_[glyph]) / 2, page_.height - page_.margin - pen - size_};
  }
  const double base = page_.height - page_.margin - size_ - across;
  const double x =
      RunsBack() ? page_.width - page_.margin - pen - right_[glyph] : page_.margin + pen;
  return {x, base};
}

void Layout::Put(const Sign& sign) {
  PlacedGlyph placed;
  placed.glyph = sign.glyph;
  placed.line = next_row_ - 1;
  placed.origin_P = OriginOf(sign.glyph, pen_);
  placed.source_begin = sign.begin;
  placed.source_end = sign.end;
  placed.word = words_ - 1;
  const double lowest = placed.origin_P.y + lowest_[sign.glyph];
  if (lowest < -kSlack) {
    throw InputError(
        fmt::format("the sign '{}' hangs {:.4g} mm below the sheet: choose a margin of "
                    "{:.4g} mm or more",
                    script_.glyphs[sign.glyph].name, -Mm(lowest), -Mm(lowest_[sign.glyph])));
  }
  pages_.back().glyphs.push_back(placed);
  pen_ += advance_[sign.glyph];
  row_empty_ = false;
}

void Layout::Place(const std::vector<Sign>& signs, std::size_t at) {
  const Sign& sign = signs[at];
  const std::size_t together = std::min(at + (sign.keep_next ? 2 : 1), signs.size());
  if (!row_empty_ && !Fits(signs, at, together, pen_)) StartRow();
  if (!Fits(signs, at, at + 1, pen_)) {
    throw InputError(
        fmt::format("the page's lines are {:.4g} mm {}, the letter '{}' needs "
                    "{:.4g} mm: choose smaller letters or a larger page",
                    Mm(line_length_), direction_ == LineDirection::kVertical ? "high" : "wide",
                    script_.glyphs[sign.glyph].name, Mm(extent_[sign.glyph])));
  }
  Put(sign);
}

void Layout::AddLine(const std::vector<Sign>& signs) {
  if (std::all_of(signs.begin(), signs.end(), [](const Sign& sign) { return sign.space; })) {
    EndParagraph();
  } else if (Alternates()) {
    AddRunning(signs);
  } else {
    AddWrapped(signs);
  }
}

void Layout::AddWrapped(const std::vector<Sign>& signs) {
  StartRow();
  bool new_word = true;
  for (std::size_t at = 0; at < signs.size();) {
    if (signs[at].space) {
      pen_ += space_;
      ++at;
      new_word = true;
      continue;
    }
    const std::size_t end = ChunkEnd(signs, at);
    if (!Fits(signs, at, end, pen_)) {
      if (!row_empty_) StartRow();
      pen_ = 0;  // spaces at the wrap, or an indent that leaves no room
    }
    if (new_word) ++words_;
    new_word = false;
    for (; at < end; ++at) Place(signs, at);
  }
}

// From the strokes of a line's last sign to its guide: the usual gap, and behind a finished word
// the space too.
double Layout::ClosingGap(std::size_t glyph, bool finished) const {
  return advance_[glyph] - extent_[glyph] + (finished ? space_ : 0);
}

// Whether a sign fits on the row with its guide behind it.
bool Layout::FitsBeforeGuide(const std::vector<Sign>& signs, std::size_t at) const {
  const bool together = signs[at].keep_next && at + 1 < signs.size() && !signs[at + 1].space;
  const double pen = pen_ + (together ? advance_[signs[at].glyph] : 0);
  const std::size_t last = together ? at + 1 : at;
  const bool finished = last + 1 == signs.size() || signs[last + 1].space;
  const std::size_t glyph = signs[last].glyph;
  return pen + extent_[glyph] + ClosingGap(glyph, finished) + bulge_ <= line_length_ + kSlack;
}

// Ends a running row behind the sign that was set last, with a guide to the next.
void Layout::Wrap(const Sign& last) {
  const bool finished = last.space;
  const PlacedGlyph end = pages_.back().glyphs.back();
  const double gap = ClosingGap(end.glyph, finished);
  // What was added behind the last sign (its own gap, spaces) is not counted.
  const glm::dvec2 origin = end.origin_P;
  const double reached = RunsBack() ? page_.width - page_.margin - origin.x
                                    : origin.x + right_[end.glyph] - page_.margin;
  const double guide = reached + gap;  // from the row's start
  const std::size_t pages = pages_.size();
  const std::size_t glyph = RunsBack() ? guide_left_ : guide_right_;
  PlacedGlyph placed = end;
  placed.glyph = glyph;
  placed.source_begin = placed.source_end;
  if (glyph != Script::npos) {
    placed.origin_P = {RunsBack() ? page_.width - page_.margin - guide : page_.margin + guide,
                       origin.y};
  }
  StartRow();
  if (pages_.size() > pages) return;  // no line follows on that page
  if (glyph != Script::npos) pages_.back().glyphs.push_back(placed);
  pen_ = line_length_ - guide + gap;
}

void Layout::AddRunning(const std::vector<Sign>& signs) {
  if (pages_.empty()) StartRow();
  if (!row_empty_) pen_ += paragraph_gap_;
  paragraph_ended_ = false;
  bool new_word = true;
  const Sign* before = nullptr;
  for (std::size_t at = 0; at < signs.size(); ++at) {
    const Sign& sign = signs[at];
    if (sign.space) {
      if (!row_empty_) pen_ += space_;
      new_word = true;
    } else {
      Sign end;
      end.space = before == nullptr || before->space;
      if (!row_empty_ && !FitsBeforeGuide(signs, at)) {
        Wrap(end);
        // A line too short to begin under its guide begins at the margin.
        if (!Fits(signs, at, at + 1, pen_)) pen_ = 0;
      }
      if (new_word) ++words_;
      new_word = false;
      Place(signs, at);
    }
    before = &sign;
  }
}

}  // namespace moontrace
