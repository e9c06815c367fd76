#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "textures/fonts/script.h"
#include "textures/typeset/text_page.h"
#include "textures/typeset/writer.h"

namespace moontrace {

/// What a row of letters of one size needs. Lengths in metres.
struct RowMetrics {
  double size = 0, space = 0;
  double gap = 0;                       ///< between one row and the next: line pitch less size
  double bulge = 0;                     ///< of guide lines
  std::vector<double> advance, extent;  ///< by glyph, along the line
  std::vector<double> right, lowest;    ///< by glyph, of its strokes
};

/// Guide lines bulge by this share of the line pitch.
constexpr double kGuideBulge = 0.3;

/// Metrics of rows in a style, all lengths times `scale`.
RowMetrics MeasureRows(const Script& script, const TypeStyle& style, double scale);

/// Adds the guide lines of old Moon to a script, as the glyphs "guide-right" and "guide-left": arcs
/// that lead from the middle of a line's end to the middle of the next, bulging by 0.3 of the line
/// pitch. That they were flat parentheses is known, the proportion is ours. A second call replaces
/// those of the first.
void AddGuides(Script& script, const TypeStyle& style);
bool IsGuide(const Glyph& glyph);

/// Sets signs in lines, and lines on pages, which it gives away one after the other: a page is
/// finished once the next but one begins, since a heading at its foot may still move on. Lengths
/// along a line are counted from its start, so that only Place knows where lines run on the page.
///
/// Between rows of different sizes lies the larger of their gaps. A heading that nothing follows on
/// its page goes to the next with what does, unless it begins the page. Rows of a quotation are
/// indented by an em, where lines do not alternate.
///
/// A word that no line holds is broken at a space at which no line should end, else where no mark
/// is parted from what it belongs to (line_ends.h), else between any two signs, and fills its rows;
/// a number that is broken has its numeral sign again on the new row.
///
/// Alternating lines follow old Moon: text runs on, a line of the text ends in a paragraph's space;
/// a word is broken where the line ends, without a mark; a broken part stands close to the guide
/// line, a finished word keeps its space; the next line begins under the guide's lower end. A
/// heading and what follows it begin a row of their own, as if on a page's top.
class Layout {
 public:
  /// Throws InputError when the page holds no line.
  Layout(const Script& script, const TypeStyle& style, const PageSpec& page, TakePage take);

  /// The first row of each page from now on: `head` at its start, and at its end what `number`
  /// gives for the page, counted from 1. Throws InputError when no row of text is left below it.
  using NumberSigns = std::function<std::vector<Sign>(std::size_t page)>;
  void SetHead(std::vector<Sign> head, NumberSigns number);
  /// Words may end a row where their signs say `hyphen_after`, with this sign behind them, though
  /// not right behind a hyphen of the text; it then stands at every break within a word, unless
  /// that is behind a mark, or the line is so short that a single sign would stand beside it.
  void SetHyphen(const Sign& hyphen) { hyphen_ = hyphen; }

  /// Sets one line of the text, wrapped into as many rows as it needs. Throws InputError when a
  /// sign is wider than the page, or the page holds no row of a heading. With `begins` false the
  /// signs go on with the line that was added last, which ended in a space or within a word.
  void AddLine(const std::vector<Sign>& signs, LineKind kind = LineKind::kPlain,
               bool begins = true);
  /// Gives away what is left.
  void Finish() { GiveAllBut(0); }

 private:
  static constexpr double kSlack = 1e-9;  // a line that fits but for rounding fits [m]

  bool Alternates() const { return direction_ == LineDirection::kAlternate; }
  bool RunsBack() const;
  const RowMetrics& RowsOf(LineKind kind) const {
    return kind == LineKind::kHeading ? heading_ : plain_;
  }
  const RowMetrics& Row() const { return RowsOf(kind_); }
  double Across(std::size_t row) const;
  void CheckRoom() const;
  double Deviation() const;
  void NextPage();
  void PutHead();
  void GiveAllBut(std::size_t kept);
  void StartRow();
  void EndParagraph();
  void Wrap(const Sign& last);
  void BeginRunning();
  void AddRunning(const std::vector<Sign>& signs);
  void AddSign(const std::vector<Sign>& signs, std::size_t at, bool& new_word);
  void AddWrapped(const std::vector<Sign>& signs);
  // Where a row may end within a chunk, in the order of choice.
  enum class Break { kPattern, kAtSpace, kBehindMark, kKeepingMarks, kKeepingGroups, kAnywhere };
  static bool MayEnd(const Sign& sign, Break how);
  bool NeedsHyphen(const Sign& last, const Sign& next) const;
  std::size_t PartEnd(const std::vector<Sign>& signs, std::size_t at, std::size_t end, Break how,
                      bool hyphenated) const;
  std::size_t PartEnd(const std::vector<Sign>& signs, std::size_t at, std::size_t end,
                      bool forced) const;
  double AdvanceOf(const Sign& sign) const {
    return sign.space ? Row().space : Row().advance[sign.glyph];
  }
  double ExtentOf(const Sign& sign) const { return sign.space ? 0 : Row().extent[sign.glyph]; }
  std::size_t ForcedEnd(const std::vector<Sign>& signs, std::size_t at, std::size_t end) const;
  bool HoldsUnit(const std::vector<Sign>& signs, std::size_t at, std::size_t end, Break how) const;
  void BreakRow(const Sign& last, const Sign& next);
  void RepeatNumeral(const Sign& digit);
  std::size_t ChunkEnd(const std::vector<Sign>& signs, std::size_t at) const;
  bool Fits(const std::vector<Sign>& signs, std::size_t at, std::size_t end, double pen) const;
  bool FitsBeforeGuide(const std::vector<Sign>& signs, std::size_t at, double pen) const;
  bool MustWrap(const std::vector<Sign>& signs, std::size_t at) const;
  double ClosingGap(std::size_t glyph, bool finished) const;
  void Place(const std::vector<Sign>& signs, std::size_t at);
  void Put(const Sign& sign);
  glm::dvec2 OriginOf(std::size_t glyph, double pen) const;

  const Script& script_;
  LineDirection direction_;
  PageSpec page_;
  RowMetrics plain_, heading_;
  double line_length_ = 0, line_pitch_ = 0, room_ = 0;  // [m]
  double paragraph_gap_ = 0;                            // [m]
  bool empty_rows_ = true;                              // between paragraphs, in place of the gap
  std::size_t guide_right_ = Script::npos, guide_left_ = Script::npos;
  std::size_t numeral_ = Script::npos;

  std::vector<Sign> head_;
  NumberSigns number_;
  std::size_t head_rows_ = 0;  // 0 or 1
  std::size_t pages_begun_ = 0;
  std::optional<Sign> hyphen_;

  TakePage take_;
  Box sheet_P_;                   // [m]
  std::vector<TextPage> pages_;   // the last ones
  std::size_t next_row_ = 0;      // on the last page
  double gaps_ = 0;               // on the last page beyond rows of the text's pitch [m]
  bool paragraph_ended_ = false;  // a blank line stands before the next
  bool line_begun_ = false;       // the line that goes on has signs
  LineKind kind_ = LineKind::kPlain, kind_before_ = LineKind::kPlain;  // of this row, the last one
  double indent_ = 0, pen_ = 0;                                        // from the row's start [m]
  double text_start_ = 0;  // of the row: behind its indent and a repeated numeral sign [m]
  bool row_empty_ = true;
  std::size_t words_ = 0;
  std::size_t run_row_ = 0;  // the row at which alternating lines began to run

  // Where the heading begins that ends the last page so far: its first glyph, row and gaps.
  struct Heading {
    std::size_t glyph = Script::npos, row = 0;
    double gaps = 0;  // [m]
  };
  Heading last_heading_;
};

}  // namespace moontrace
