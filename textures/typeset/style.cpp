#include "textures/typeset/style.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "textures/base/enum_names.h"
#include "textures/base/error.h"
#include "textures/base/units.h"

namespace moontrace {
namespace {

// A fingertip resolves nothing in smaller letters; it also keeps the arithmetic in range.
constexpr double kSmallestSize = 1e-3;  // [m]

// Strokes of one sign and of neighbouring letters lie half an em apart or more (the bars of the
// division sign 0.51, the numeral's dot and bar 0.5, letters 0.57): wider grooves would merge.
constexpr double kWidestGroove = 0.5;  // [em]

// To leave a groove the tip needs a sideways force of slope x press. At the usual press of 1 N and
// slope 5 this is 5 N, beyond the field's cap of 3 N and what desk-top devices give.
constexpr double kSteepestFlank = 5;

constexpr double kLargeSize = 8e-3, kSmallSize = 6e-3;  // [m], between them the groove widens
constexpr double kSmallWidth = 0.2;                     // w of small letters [em]

constexpr double kGreatestHeading = 5;  // over the text

constexpr double kLargestGap = 1;  // between paragraphs [m]

void CheckPositive(double value, const char* what) {
  if (!std::isfinite(value) || value <= 0) {
    throw InputError(
        fmt::format("{} of {:.6g} mm: give a number above zero", what, InMillimetres(value)));
  }
}

void CheckGroove(const TypeStyle& style) {
  CheckPositive(style.width, "groove width");
  CheckPositive(style.depth, "groove depth");
  CheckPositive(style.rounding, "rounding");
  const double widest = kWidestGroove * style.size * std::min(style.form.stretch, 1.0);
  if (style.width > widest) {
    throw InputError(
        fmt::format("groove width {:.4g} mm is wider than a letter of {:.4g} mm can "
                    "hold: at most {:.4g} mm",
                    InMillimetres(style.width), InMillimetres(style.size), InMillimetres(widest)));
  }
  // A rounding of exactly w/4 may come in with an error from unit conversion.
  if (style.rounding > style.width / 4 * (1 + 1e-12)) {
    throw InputError(fmt::format(
        "rounding {:.4g} mm is above a quarter of the groove width "
        "{:.4g} mm: at most {:.4g} mm",
        InMillimetres(style.rounding), InMillimetres(style.width), InMillimetres(style.width / 4)));
  }
  const double run = style.width / 2 - style.rounding;
  if (style.depth > kSteepestFlank * run) {
    throw InputError(
        fmt::format("groove depth {:.4g} mm is too steep for the width {:.4g} mm: at "
                    "most {:.4g} mm",
                    InMillimetres(style.depth), InMillimetres(style.width),
                    InMillimetres(kSteepestFlank * run)));
  }
  if (!(style.blend_radius >= 0 && style.blend_radius <= style.width / 2)) {
    throw InputError(
        fmt::format("blend radius {:.4g} mm: give 0 to half the groove width, "
                    "{:.4g} mm",
                    InMillimetres(style.blend_radius), InMillimetres(style.width / 2)));
  }
}

void CheckLinks(const TypeStyle& style) {
  // Written so that a NaN fails.
  if (!(style.links.depth > 0 && style.links.depth <= 1)) {
    throw InputError(
        fmt::format("links of {:.4g} of the letters' depth: give above 0 to 1", style.links.depth));
  }
  const double gap = style.links.gap.value_or(0);
  if (!(gap >= 0 && gap <= style.size)) {
    throw InputError(fmt::format("link gap {:.4g} mm: give 0 to {:.4g} mm, a letter's height",
                                 InMillimetres(gap), InMillimetres(style.size)));
  }
}

void CheckSpacing(const TypeStyle& style, const Script& script) {
  double narrowest = HUGE_VAL;
  for (const Glyph& glyph : script.glyphs) narrowest = std::min(narrowest, glyph.advance);
  narrowest *= style.size;
  // A gap that is not finite fails as well; so does a script without glyphs.
  if (!(narrowest + style.letter_gap > 0 && std::isfinite(narrowest + style.letter_gap))) {
    throw InputError(
        fmt::format("letter gap {:.4g} mm: letters would run backwards, give more "
                    "than {:.4g} mm",
                    InMillimetres(style.letter_gap), -InMillimetres(narrowest)));
  }
  const double space = script.space_advance * style.size;
  if (!(space + style.word_gap > 0 && std::isfinite(space + style.word_gap))) {
    throw InputError(
        fmt::format("word gap {:.4g} mm: words would run backwards, give more than "
                    "{:.4g} mm",
                    InMillimetres(style.word_gap), -InMillimetres(space)));
  }
  // Below that, the feet of one line and the tops of the next are one groove.
  CheckPositive(style.line_pitch, "line pitch");
  if (style.line_pitch < style.size + style.width) {
    throw InputError(
        fmt::format("line pitch {:.4g} mm: lines would run into each other, at least "
                    "{:.4g} mm",
                    InMillimetres(style.line_pitch), InMillimetres(style.size + style.width)));
  }
}

constexpr std::string_view NameOfReach(LinkReach reach) {
  switch (reach) {
    case LinkReach::kNone:
      return "none";
    case LinkReach::kLetters:
      return "letters";
    case LinkReach::kWords:
      return "words";
  }
  return {};
}

constexpr std::string_view NameOfLines(LineDirection lines) {
  switch (lines) {
    case LineDirection::kLeftToRight:
      return "left-to-right";
    case LineDirection::kRightToLeft:
      return "right-to-left";
    case LineDirection::kAlternate:
      return "alternate";
    case LineDirection::kVertical:
      return "vertical";
  }
  return {};
}

}  // namespace

std::optional<LinkReach> LinkReachOf(std::string_view name) {
  return ValueNamed(name, &NameOfReach);
}

std::string NameOf(LinkReach reach) { return std::string(NameOfReach(reach)); }

std::optional<LineDirection> LineDirectionOf(std::string_view name) {
  return ValueNamed(name, &NameOfLines);
}

std::string NameOf(LineDirection lines) { return std::string(NameOfLines(lines)); }

namespace {

// 0 for large letters, 1 for small ones.
double Smallness(double size) {
  return std::clamp((kLargeSize - size) / (kLargeSize - kSmallSize), 0.0, 1.0);
}

// Depth and blend that follow from size and width.
void ChooseDepth(TypeStyle& style, const Script& script) {
  const bool engraved = style.relief == Relief::kEngraved;
  style.depth = engraved ? style.width * (1.0 / 2 + Smallness(style.size) * (1.0 / 3 - 1.0 / 2))
                         : style.width / 4;
  style.blend_radius = engraved ? 0 : style.width / 4;
  if (script.depth > 0) style.depth = script.depth * style.size;
}

}  // namespace

TypeStyle DefaultStyle(double size, Relief relief, const Script& script) {
  TypeStyle style;
  style.size = size;
  style.relief = relief;
  const double small = Smallness(size);
  const double small_width = std::max(kSmallWidth, script.stroke_width);
  style.width = size * (script.stroke_width + small * (small_width - script.stroke_width));
  style.rounding = 0.2 * style.width;
  ChooseDepth(style, script);
  style.line_pitch = script.line_pitch * size;
  return style;
}

TypeStyle LineStyle(LineKind kind, const TypeStyle& style, const Script& script) {
  TypeStyle line = style;
  const double scale = ScaleOf(kind, style);
  for (double* length : {&line.size, &line.width, &line.depth, &line.rounding, &line.blend_radius,
                         &line.letter_gap, &line.word_gap, &line.line_pitch}) {
    *length *= scale;
  }
  if (kind != LineKind::kHeading || !style.structure.heading_relief) return line;
  line.relief = *style.structure.heading_relief;
  if (line.relief != style.relief) ChooseDepth(line, script);
  return line;
}

void CheckStyle(const TypeStyle& style, const Script& script) {
  const double scale = style.structure.heading_scale;
  if (!(scale >= 1 && scale <= kGreatestHeading)) {
    throw InputError(fmt::format("headings of {:.4g} times the size: give 1 to {:.4g}", scale,
                                 kGreatestHeading));
  }
  CheckPositive(style.size, "letter size");
  if (style.size < kSmallestSize) {
    throw InputError(fmt::format("letter size {:.4g} mm is too small to feel: at least {:.4g} mm",
                                 InMillimetres(style.size), InMillimetres(kSmallestSize)));
  }
  CheckGroove(style);
  CheckLinks(style);
  CheckSpacing(style, script);
  const double gap = style.paragraph_gap.value_or(0);
  if (!(gap >= 0 && gap <= kLargestGap)) {
    throw InputError(fmt::format("paragraph gap {:.4g} mm: give 0 to {:.4g} mm", InMillimetres(gap),
                                 InMillimetres(kLargestGap)));
  }
}

}  // namespace moontrace
