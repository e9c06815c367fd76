#include "textures/typeset.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "textures/error.h"
#include "textures/fold.h"
#include "textures/signs.h"

namespace moontrace {
namespace {

constexpr std::size_t kMostSigns = std::size_t{16} << 20;
constexpr double kSlack = 1e-9;         // a line that fits but for rounding fits [m]
constexpr double kCustomMargin = 0.01;  // [m]
constexpr double kLargestPage = 5;      // [m]

double Mm(double metres) { return metres * 1000; }

bool ReadNumber(std::string_view text, double& value) {
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  return read.ec == std::errc() && read.ptr == text.data() + text.size();
}

void CheckPage(const PageSpec& page) {
  const double shorter = std::min(page.width, page.height);
  // Written so that a NaN fails.
  if (!(page.margin >= 0 && shorter > 2 * page.margin &&
        std::max(page.width, page.height) <= kLargestPage)) {
    throw InputError(
        fmt::format("page {:.6g} x {:.6g} mm with margins of {:.6g} mm: give sides "
                    "above twice the margin, up to {:.0f} mm",
                    Mm(page.width), Mm(page.height), Mm(page.margin), Mm(kLargestPage)));
  }
}

// Greatest x of the strokes' centre lines [em].
double RightEdge(const Glyph& glyph) {
  double right = 0;
  for (const Stroke& stroke : glyph.strokes) {
    for (const Piece& piece : stroke.pieces) right = std::max(right, BoundsOf(piece).max.x);
  }
  return right;
}

// Sets signs in rows, and rows on pages.
class Layout {
 public:
  Layout(const Script& script, const TypeStyle& style, const PageSpec& page);

  // Sets one line of the text, wrapped into as many rows as it needs.
  void AddLine(const std::vector<Sign>& signs);
  std::vector<TextPage> TakePages() { return std::move(pages_); }

 private:
  void StartRow();
  std::size_t ChunkEnd(const std::vector<Sign>& signs, std::size_t at) const;
  bool Fits(const std::vector<Sign>& signs, std::size_t at, std::size_t end, double pen) const;
  void Place(const std::vector<Sign>& signs, std::size_t at);

  const Script& script_;
  double line_width_ = 0, space_ = 0, left_ = 0, first_base_ = 0, line_pitch_ = 0;  // [m]
  std::vector<double> advance_, right_;                                             // by glyph [m]
  std::size_t rows_on_page_ = 0;

  std::vector<TextPage> pages_;
  std::size_t next_row_ = 0;    // on the last page
  bool blank_pending_ = false;  // an empty row is due before the next
  double pen_ = 0;              // from the left margin [m]
  bool row_empty_ = true;
  std::size_t words_ = 0;
};

Layout::Layout(const Script& script, const TypeStyle& style, const PageSpec& page)
    : script_(script),
      line_width_(page.width - 2 * page.margin),
      space_(script.space_advance * style.size + style.word_gap),
      left_(page.margin),
      first_base_(page.height - page.margin - style.size),
      line_pitch_(style.line_pitch) {
  const double room = page.height - 2 * page.margin - style.size + kSlack;
  if (room < 0) {
    throw InputError(
        fmt::format("the page has {:.4g} mm between its margins, a line needs {:.4g} "
                    "mm: choose smaller letters or a larger page",
                    Mm(page.height - 2 * page.margin), Mm(style.size)));
  }
  rows_on_page_ = 1 + static_cast<std::size_t>(room / line_pitch_);
  for (const Glyph& glyph : script.glyphs) {
    advance_.push_back(glyph.advance * style.size + style.letter_gap);
    right_.push_back(RightEdge(glyph) * style.size);
  }
}

void Layout::StartRow() {
  if (blank_pending_ && !pages_.empty()) ++next_row_;
  blank_pending_ = false;
  if (pages_.empty() || next_row_ >= rows_on_page_) {
    const std::size_t expected = pages_.empty() ? 0 : pages_.back().glyphs.size();
    pages_.emplace_back();
    pages_.back().glyphs.reserve(expected);
    next_row_ = 0;
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
    if (pen + right_[signs[at].glyph] > line_width_ + kSlack) return false;
    pen += advance_[signs[at].glyph];
  }
  return true;
}

void Layout::Place(const std::vector<Sign>& signs, std::size_t at) {
  const Sign& sign = signs[at];
  const std::size_t together = std::min(at + (sign.keep_next ? 2 : 1), signs.size());
  if (!row_empty_ && !Fits(signs, at, together, pen_)) StartRow();
  if (!Fits(signs, at, at + 1, pen_)) {
    throw InputError(
        fmt::format("the page's lines are {:.4g} mm wide, the letter '{}' needs "
                    "{:.4g} mm: choose smaller letters or a larger page",
                    Mm(line_width_), script_.glyphs[sign.glyph].name, Mm(right_[sign.glyph])));
  }
  PlacedGlyph placed;
  placed.glyph = sign.glyph;
  placed.line = next_row_ - 1;
  placed.origin_P = {left_ + pen_, first_base_ - static_cast<double>(placed.line) * line_pitch_};
  placed.source_begin = sign.begin;
  placed.source_end = sign.end;
  placed.word = words_ - 1;
  pages_.back().glyphs.push_back(placed);
  pen_ += advance_[sign.glyph];
  row_empty_ = false;
}

void Layout::AddLine(const std::vector<Sign>& signs) {
  if (std::all_of(signs.begin(), signs.end(), [](const Sign& sign) { return sign.space; })) {
    blank_pending_ = true;
    return;
  }
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

}  // namespace

PageSpec FindPage(const std::string& name) {
  if (name == "a4") return {"a4", 0.210, 0.297, 0.015};
  if (name == "a5") return {"a5", 0.148, 0.210, 0.015};
  if (name == "workspace") return {"workspace", 0.160, 0.120, 0.010};
  const std::size_t times = name.find('x');
  double width_mm = 0, height_mm = 0;
  if (times == std::string::npos ||
      !ReadNumber(std::string_view(name).substr(0, times), width_mm) ||
      !ReadNumber(std::string_view(name).substr(times + 1), height_mm)) {
    throw InputError(
        fmt::format("unknown page '{}': choose a4, a5, workspace, or a size in mm "
                    "like 120x90",
                    Shown(name)));
  }
  PageSpec page{"custom", width_mm / 1000, height_mm / 1000, kCustomMargin};
  CheckPage(page);
  return page;
}

Typeset SetText(std::string_view text, const Script& script, const TypeStyle& style,
                const PageSpec& page) {
  CheckStyle(style, script);
  CheckPage(page);
  const SignWriter writer(script, style.grade, style.h_form);
  Folder folder(text, script);
  Layout layout(script, style, page);

  Typeset result;
  result.style = style;
  result.page = page;
  std::vector<FoldedChar> line;
  std::vector<Sign> signs;
  std::size_t count = 0;
  for (std::size_t number = 1; folder.NextLine(line); ++number) {
    signs.clear();
    writer.Write(text, number, line, signs, result);
    count += signs.size();
    if (count > kMostSigns) {
      throw InputError(
          fmt::format("the text makes more than {} million signs: split it", kMostSigns >> 20));
    }
    layout.AddLine(signs);
  }
  result.pages = layout.TakePages();
  if (!result.pages.empty()) return result;
  if (result.missing_count == 0) {
    throw InputError("the text is empty or blank: give at least one letter");
  }
  const Replacement& first = result.missing.front();
  throw InputError(
      fmt::format("nothing left to set: script {} has no form of any of the {} "
                  "characters, the first is '{}' (line {}, column {}): use others",
                  script.name, result.missing_count, first.was, first.line, first.column));
}

}  // namespace moontrace
