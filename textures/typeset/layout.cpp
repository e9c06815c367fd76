#include "textures/typeset/layout.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "textures/base/error.h"
#include "textures/base/units.h"

namespace moontrace {
namespace {

constexpr double kGuideAdvance = 0.9;  // [em]; nothing follows a guide on its line

constexpr double kMostIndent = 0.125;  // of a quotation, of the line

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

RowMetrics MeasureRows(const Script& script, const TypeStyle& style, double scale) {
  const bool vertical = style.lines == LineDirection::kVertical;
  const double letter_gap = scale * style.letter_gap;
  RowMetrics row;
  row.size = scale * style.size;
  row.space = script.space_advance * row.size + scale * style.word_gap;
  row.gap = scale * (style.line_pitch - style.size);
  row.bulge = kGuideBulge * (scale * style.line_pitch);
  for (const Glyph& glyph : script.glyphs) {
    const Box bounds = BoundsOf(glyph);
    row.right.push_back(bounds.max.x * row.size);
    row.lowest.push_back(LowestMiddle(glyph) * row.size);
    const double advance = glyph.advance * row.size + letter_gap;
    // Down a column each sign has its whole box, and below it the gap that it has along a line.
    row.extent.push_back(vertical ? row.size : row.right.back());
    row.advance.push_back(vertical ? row.size + std::max(advance - row.right.back(), 0.0)
                                   : advance);
  }
  return row;
}

bool IsGuide(const Glyph& glyph) {
  return glyph.name == "guide-right" || glyph.name == "guide-left";
}

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

Layout::Layout(const Script& script, const TypeStyle& style, const PageSpec& page, TakePage take)
    : script_(script),
      direction_(style.lines),
      page_(page),
      plain_(MeasureRows(script, style, 1)),
      line_pitch_(style.line_pitch),
      take_(std::move(take)),
      sheet_P_{{0, 0}, {page.width, page.height}} {
  const bool vertical = direction_ == LineDirection::kVertical;
  line_length_ = (vertical ? page.height : page.width) - 2 * page.margin;
  room_ = (vertical ? page.width : page.height) - 2 * page.margin;
  CheckRoom();
  if (style.structure.read) {
    heading_ = MeasureRows(script, style, ScaleOf(LineKind::kHeading, style));
  }
  empty_rows_ = !style.paragraph_gap;
  paragraph_gap_ = style.paragraph_gap.value_or(Alternates() ? 2 * plain_.space : line_pitch_);
  if (!script.digits.empty()) numeral_ = script.Find(script.numeral_sign);
  if (Alternates()) {
    guide_right_ = script.Find("guide-right");
    guide_left_ = script.Find("guide-left");
  }
}

// Whether the page holds a row of the kind that is set.
void Layout::CheckRoom() const {
  const double head = static_cast<double>(head_rows_) * line_pitch_;
  if (room_ - head - Row().size + kSlack >= 0) return;
  throw InputError(
      fmt::format("page: {:.4g} mm within its margins, a line needs {:.4g} mm: choose smaller "
                  "letters",
                  InMillimetres(room_), InMillimetres(head + Row().size)));
}

void Layout::SetHead(std::vector<Sign> head, NumberSigns number) {
  head_ = std::move(head);
  number_ = std::move(number);
  head_rows_ = 1;
  CheckRoom();
}

// Sets the head of the page that has just begun.
void Layout::PutHead() {
  if (head_rows_ == 0) return;
  const LineKind kind = std::exchange(kind_, LineKind::kHead);
  next_row_ = 1;
  gaps_ = 0;
  run_row_ = 0;
  const auto length_of = [this](const std::vector<Sign>& signs) {
    double length = 0, reached = 0;
    for (const Sign& sign : signs) {
      if (!sign.space) reached = length + Row().extent[sign.glyph];
      length += sign.space ? Row().space : Row().advance[sign.glyph];
    }
    return reached;
  };
  const auto put = [this](const std::vector<Sign>& signs, double from) {
    pen_ = from;
    ++words_;
    for (const Sign& sign : signs) {
      if (sign.space) {
        pen_ += Row().space;
        ++words_;
      } else {
        Put(sign);
      }
    }
  };
  const std::vector<Sign> number = number_ ? number_(pages_begun_) : std::vector<Sign>();
  const double number_length = length_of(number), head_length = length_of(head_);
  const double between = head_.empty() || number.empty() ? 0 : Row().space;
  if (head_length + between + number_length > line_length_ + kSlack) {
    const char* what = number.empty()  ? "the running head needs"
                       : head_.empty() ? "page numbers need"
                                       : "running head and page number need";
    throw InputError(fmt::format("{} {:.4g} mm, lines are {:.4g} mm: choose {}smaller letters",
                                 what, InMillimetres(head_length + between + number_length),
                                 InMillimetres(line_length_),
                                 head_.empty() ? "" : "fewer words or "));
  }
  put(head_, 0);
  if (!number.empty()) put(number, line_length_ - number_length);
  ++words_;  // what is left of a broken word is a word of its own
  pages_.back().lines = 1;
  kind_ = kind;
  run_row_ = head_rows_;
}

// Whether the row that is being set runs right to left.
bool Layout::RunsBack() const {
  if (direction_ == LineDirection::kRightToLeft) return true;
  return Alternates() && (next_row_ - run_row_) % 2 == 0;
}

void Layout::EndParagraph() { paragraph_ended_ = true; }

// How far a row of the last page lies from the margin.
double Layout::Across(std::size_t row) const {
  return static_cast<double>(row) * line_pitch_ + gaps_;
}

// What the step from the row before to this one is beyond the text's pitch.
double Layout::Deviation() const {
  const RowMetrics& before = RowsOf(kind_before_);
  if (pages_.empty() || (&before == &plain_ && &Row() == &plain_)) return 0;
  return before.size + std::max(before.gap, Row().gap) - line_pitch_;
}

// Begins a page, with the heading that would else stand alone at the foot of the last.
void Layout::NextPage() {
  const Heading moved = std::exchange(last_heading_, Heading{});
  const std::size_t expected = pages_.empty() ? 0 : pages_.back().glyphs.size();
  GiveAllBut(1);
  pages_.emplace_back();
  ++pages_begun_;
  TextPage& page = pages_.back();
  page.glyphs.reserve(expected + expected / 4);  // pages of a text are much alike
  const std::size_t row = next_row_, run_row = run_row_;
  const double gaps = gaps_;
  next_row_ = run_row_ = 0;
  gaps_ = 0;
  PutHead();
  if (moved.glyph == Script::npos || moved.row <= head_rows_) return;
  const std::size_t head_glyphs = page.glyphs.size();
  const std::size_t rows = moved.row - head_rows_;
  TextPage& before = pages_[pages_.size() - 2];
  const double shift = static_cast<double>(rows) * line_pitch_ + moved.gaps;
  const bool vertical = direction_ == LineDirection::kVertical;
  const auto first = before.glyphs.begin() + static_cast<std::ptrdiff_t>(moved.glyph);
  for (auto glyph = first; glyph != before.glyphs.end(); ++glyph) {
    glyph->line -= rows;
    glyph->origin_P += vertical ? glm::dvec2(shift, 0) : glm::dvec2(0, shift);
    page.glyphs.push_back(*glyph);
  }
  before.glyphs.erase(first, before.glyphs.end());
  before.lines = before.glyphs.back().line + 1;
  page.lines = page.glyphs.empty() ? 0 : page.glyphs.back().line + 1;
  next_row_ = row - rows;
  run_row_ = std::max(run_row, moved.row) - rows;
  gaps_ = gaps - moved.gaps;
  last_heading_ = {head_glyphs, head_rows_, 0};
}

void Layout::GiveAllBut(std::size_t kept) {
  while (pages_.size() > kept) {
    TextPage& page = pages_.front();
    page.sheet_P = sheet_P_;
    page.text_area_P = Grown(sheet_P_, -page_.margin);
    // a head stands for no byte, where the page's text begins
    const auto text = std::find_if(page.glyphs.begin(), page.glyphs.end(),
                                   [](const PlacedGlyph& g) { return g.kind != LineKind::kHead; });
    for (auto head = page.glyphs.begin(); head != text && text != page.glyphs.end(); ++head) {
      head->source_begin = head->source_end = text->source_begin;
    }
    take_(std::move(page));
    pages_.erase(pages_.begin());
  }
}

void Layout::StartRow() {
  if (paragraph_ended_ && !pages_.empty() && !Alternates()) {
    if (empty_rows_) {
      ++next_row_;
    } else {
      gaps_ += paragraph_gap_;
    }
  }
  paragraph_ended_ = false;
  gaps_ += Deviation();
  CheckRoom();
  if (pages_.empty()) NextPage();
  while (Across(next_row_) > room_ - Row().size + kSlack) NextPage();
  if (kind_ != LineKind::kHeading) {
    last_heading_ = {};
  } else if (kind_before_ != LineKind::kHeading || last_heading_.glyph == Script::npos) {
    last_heading_ = {pages_.back().glyphs.size(), next_row_, gaps_};
  }
  kind_before_ = kind_;
  pages_.back().lines = ++next_row_;
  pen_ = text_start_ = indent_;
  row_empty_ = true;
}

// Where a glyph stands whose start is `pen` from the start of the current row.
glm::dvec2 Layout::OriginOf(std::size_t glyph, double pen) const {
  const double across = Across(next_row_ - 1), size = Row().size;
  if (direction_ == LineDirection::kVertical) {
    const double column = page_.width - page_.margin - size - across;
    return {column + (size - Row().right[glyph]) / 2, page_.height - page_.margin - pen - size};
  }
  const double base = page_.height - page_.margin - size - across;
  const double x =
      RunsBack() ? page_.width - page_.margin - pen - Row().right[glyph] : page_.margin + pen;
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
  placed.kind = kind_;
  placed.link = sign.link;
  const double lowest = placed.origin_P.y + Row().lowest[sign.glyph];
  if (lowest < -kSlack) {
    throw InputError(
        fmt::format("the sign '{}' hangs {:.4g} mm below the sheet: choose a margin of "
                    "{:.4g} mm or more",
                    script_.glyphs[sign.glyph].name, -InMillimetres(lowest),
                    -InMillimetres(Row().lowest[sign.glyph])));
  }
  pages_.back().glyphs.push_back(placed);
  pen_ += Row().advance[sign.glyph];
  row_empty_ = false;
}

void Layout::AddLine(const std::vector<Sign>& signs, LineKind kind, bool begins) {
  line_begun_ = line_begun_ && !begins;
  kind_ = kind;
  const bool indented = kind == LineKind::kQuotation && !Alternates();
  indent_ = indented ? std::min(plain_.size, kMostIndent * line_length_) : 0;
  if (std::all_of(signs.begin(), signs.end(), [](const Sign& sign) { return sign.space; })) {
    if (begins) EndParagraph();
    return;
  }
  if (Alternates()) {
    if (!line_begun_) BeginRunning();
    AddRunning(signs);
  } else {
    if (!line_begun_) StartRow();
    AddWrapped(signs);
  }
  line_begun_ = true;
}

}  // namespace moontrace
