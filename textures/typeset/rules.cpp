#include "textures/typeset/rules.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>

#include "textures/base/error.h"
#include "textures/base/units.h"
#include "textures/typeset/layout.h"
#include "textures/typeset/text_page.h"

namespace moontrace {

namespace {

constexpr double kShare = 0.1;         // of the size: widths and gap
constexpr double kLinkedShare = 0.7;   // of half the space between lines beside the rules
constexpr double kHeightShare = 0.25;  // of the width
constexpr double kRounding = 0.2;      // of the width
constexpr double kSteepest = 5;        // as of grooves
constexpr double kLeastApart = 5e-4;   // [m]; a tip of 0.25 mm rests between two ridges
constexpr double kSlack = 1e-9;        // [m]

/// In hundredths of a millimetre, never less than what is needed.
double MmAtLeast(double metres) { return std::ceil(metres * 1e5 - 1e-6) / 100; }

Profile ProfileOf(double width, double height, double size) {
  const double w = width > 0 ? width : kShare * size;
  return {w, height > 0 ? height : kHeightShare * w, kRounding * w};
}

void CheckRidge(double width, double height, double size, const char* what) {
  if (!(width >= 0 && height >= 0 && std::isfinite(width + height))) {
    throw InputError(fmt::format("{}: width {:.4g} mm, height {:.4g} mm: give numbers above zero",
                                 what, InMillimetres(width), InMillimetres(height)));
  }
  const Profile profile = ProfileOf(width, height, size);
  const double slope = GreatestSlope(profile);
  if (slope <= kSteepest * (1 + 1e-12)) return;
  throw InputError(
      fmt::format("{}: height {:.4g} mm is too steep for the width {:.4g} mm: at most {:.4g} mm",
                  what, InMillimetres(profile.depth), InMillimetres(profile.width),
                  InMillimetres(profile.depth * kSteepest / slope)));
}

/// Where things lie across the lines: up the page, or from left to right where lines run down it.
class Across {
 public:
  explicit Across(const TypeStyle& style) : vertical_(style.lines == LineDirection::kVertical) {}
  double Of(glm::dvec2 p) const { return vertical_ ? p.x : p.y; }
  double Along(glm::dvec2 p) const { return vertical_ ? p.y : p.x; }
  glm::dvec2 At(double along, double across) const {
    return vertical_ ? glm::dvec2(across, along) : glm::dvec2(along, across);
  }
  bool vertical() const { return vertical_; }

 private:
  bool vertical_;
};

Box SpinesOf(const Glyph& glyph) {
  Box box;
  for (const Stroke& stroke : glyph.strokes) {
    for (const Piece& piece : stroke.pieces) Include(box, BoundsOf(piece));
  }
  return box;
}

/// A line of text: its base line, or its middle where it runs down the page, and what its strokes
/// fill on either side.
struct TextLine {
  LineKind kind = LineKind::kPlain;
  double base = 0;                          // [m]
  double low = HUGE_VAL, high = -HUGE_VAL;  // [m]
};

struct Ink {
  std::vector<TextLine> lines;  // from the greatest base to the least
  std::vector<Box> guides;
  Box all;
};

Ink InkOf(const TextPage& page, const Script& script, const TypeStyle& style) {
  const Across across(style);
  std::vector<Box> spines;
  for (const Glyph& glyph : script.glyphs) spines.push_back(SpinesOf(glyph));
  std::map<std::size_t, TextLine> lines;
  Ink ink;
  for (const PlacedGlyph& placed : page.glyphs) {
    const double scale = ScaleOf(placed.kind, style), size = scale * style.size;
    const Box& spine = spines[placed.glyph];
    if (spine.min.x > spine.max.x) continue;
    const Box box = Grown({placed.origin_P + size * spine.min, placed.origin_P + size * spine.max},
                          0.5 * scale * style.width);
    Include(ink.all, box);
    if (IsGuide(script.glyphs[placed.glyph])) {
      ink.guides.push_back(box);
      continue;
    }
    TextLine& line = lines[placed.line];
    line.kind = placed.kind;
    line.base = across.Of(placed.origin_P);
    // down a column every sign stands in the middle
    if (across.vertical()) line.base += 0.5 * size * std::max(spine.max.x, 0.0);
    line.low = std::min(line.low, across.Of(box.min));
    line.high = std::max(line.high, across.Of(box.max));
  }
  for (const auto& [number, line] : lines) ink.lines.push_back(line);
  std::sort(ink.lines.begin(), ink.lines.end(),
            [](const TextLine& a, const TextLine& b) { return a.base > b.base; });
  return ink;
}

/// How far strokes reach to either side of the base line, in all lines of a kind.
struct Reach {
  double below = 0, above = 0;  // [m]
};

std::map<LineKind, Reach> ReachOf(const std::vector<TextLine>& lines) {
  std::map<LineKind, Reach> reach;
  for (const TextLine& line : lines) {
    Reach& of_kind = reach[line.kind];
    of_kind.below = std::max(of_kind.below, line.base - line.low);
    of_kind.above = std::max(of_kind.above, line.high - line.base);
  }
  return reach;
}

/// The parts of a rule that keep away from the guide lines.
void AddRule(double across_at, const Box& area, const Across& across, double keep, double half,
             const std::vector<Box>& guides, std::vector<Line>& rules) {
  std::vector<std::pair<double, double>> parts{
      {across.Along(area.min) + half, across.Along(area.max) - half}};
  for (const Box& guide : guides) {
    if (across_at < across.Of(guide.min) - keep || across_at > across.Of(guide.max) + keep) {
      continue;
    }
    const double from = across.Along(guide.min) - keep, to = across.Along(guide.max) + keep;
    std::vector<std::pair<double, double>> left;
    for (const auto& part : parts) {
      if (to <= part.first || from >= part.second) {
        left.push_back(part);
        continue;
      }
      left.emplace_back(part.first, from);
      left.emplace_back(to, part.second);
    }
    parts = left;
  }
  for (const auto& part : parts) {
    // a scrap beyond a guide line is not found as a line
    if (part.second - part.first < 4 * keep) continue;
    rules.push_back({across.At(part.first, across_at), across.At(part.second, across_at)});
  }
}

std::vector<Line> RulesOf(const Ink& ink, const Box& area, const TypeStyle& style) {
  const Across across(style);
  const double width = RuleProfile(style).width, gap = RuleGap(style);
  const double half = 0.5 * width, away = gap + half, apart = RulesApart(style);
  std::map<LineKind, Reach> reach = ReachOf(ink.lines);
  std::vector<Line> rules;
  double free_from = HUGE_VAL;  // where the rules of the line before end
  double base_before = 0;
  for (const TextLine& line : ink.lines) {
    const Reach& own = reach[line.kind];
    const double above = line.base + own.above + away, below = line.base - own.below - away;
    if (above + half + apart > free_from + kSlack) {
      throw InputError(fmt::format(
          "line pitch {:.4g} mm leaves no room for rules {:.4g} mm wide and {:.4g} mm "
          "apart: choose a line pitch of {:.4g} mm or more",
          InMillimetres(base_before - line.base), InMillimetres(width), InMillimetres(apart),
          MmAtLeast(base_before - line.base + above + half + apart - free_from)));
    }
    AddRule(above, area, across, away, half, ink.guides, rules);
    AddRule(below, area, across, away, half, ink.guides, rules);
    free_from = below - half;
    base_before = line.base;
  }
  return rules;
}

/// A rectangle with round corners, counter-clockwise.
std::vector<Piece> Rounded(const Box& box, double radius) {
  constexpr double kQuarter = std::numbers::pi / 2;
  const glm::dvec2 a = box.min + radius, b = box.max - radius;
  return {
      Line{{a.x, box.min.y}, {b.x, box.min.y}}, Arc{{b.x, a.y}, radius, -kQuarter, kQuarter},
      Line{{box.max.x, a.y}, {box.max.x, b.y}}, Arc{{b.x, b.y}, radius, 0, kQuarter},
      Line{{b.x, box.max.y}, {a.x, box.max.y}}, Arc{{a.x, b.y}, radius, kQuarter, kQuarter},
      Line{{box.min.x, b.y}, {box.min.x, a.y}}, Arc{{a.x, a.y}, radius, 2 * kQuarter, kQuarter}};
}

/// How far a box hangs over the sheet [m].
double Overhang(const Box& box, const Box& sheet) {
  return std::max({sheet.min.x - box.min.x, sheet.min.y - box.min.y, box.max.x - sheet.max.x,
                   box.max.y - sheet.max.y});
}

void CheckSheet(const Box& box, const TextPage& page, const char* what) {
  const double over = Overhang(box, page.sheet_P);
  if (over <= kSlack) return;
  const double margin = page.text_area_P.min.x - page.sheet_P.min.x;
  throw InputError(fmt::format("{}: no room in a margin of {:.4g} mm, choose {:.4g} mm or more",
                               what, InMillimetres(margin), MmAtLeast(margin + over)));
}

std::shared_ptr<const Group> Ridge(const std::vector<Piece>& pieces, const Profile& profile,
                                   bool closed) {
  Group group;
  for (const Piece& piece : pieces) {
    std::visit([&](const auto& shape) { group.elements.push_back({shape, profile}); }, piece);
  }
  for (const Piece& piece : pieces) group.elements.push_back({Dot{StartOf(piece)}, profile});
  if (!closed) group.elements.push_back({Dot{EndOf(pieces.back())}, profile});
  return Finish(std::move(group));
}

}  // namespace

Profile RuleProfile(const TypeStyle& style) {
  return ProfileOf(style.rules.width, style.rules.height, style.size);
}

Profile MarginProfile(const TypeStyle& style) {
  return ProfileOf(style.rules.margin_width, style.rules.margin_height, style.size);
}

double RuleGap(const TypeStyle& style) {
  const double least = kShare * style.size;
  if (style.links.reach == LinkReach::kNone) return least;
  // links run between letters and rule
  const double free = style.line_pitch - style.size - style.width - 2 * RuleProfile(style).width;
  return std::max(least, kLinkedShare * free / 2);
}

double RulesApart(const TypeStyle& style) {
  return std::max(RuleProfile(style).width, kLeastApart);
}

double LeastRuledPitch(const std::set<std::size_t>& glyphs, const Script& script,
                       const TypeStyle& style) {
  const Across across(style);
  double below = 0, above = 0;  // of the strokes' rims from the base line [m]
  for (const std::size_t number : glyphs) {
    const Glyph& glyph = script.glyphs.at(number);
    const Box spine = SpinesOf(glyph);
    if (spine.min.x > spine.max.x || IsGuide(glyph)) continue;
    const double base = across.vertical() ? 0.5 * std::max(spine.max.x, 0.0) : 0;
    below = std::max(below, style.size * (base - across.Of(spine.min)));
    above = std::max(above, style.size * (across.Of(spine.max) - base));
  }
  const double reach = below + above + style.width, width = RuleProfile(style).width;
  const double taken = reach + 2 * width + RulesApart(style);
  const double least = taken + 2 * kShare * style.size;
  if (style.links.reach == LinkReach::kNone) return least;
  // there RuleGap grows with the pitch p: p >= taken + 0.7 (p - size - width - 2 rules)
  const double letters = style.size + style.width + 2 * width;
  return std::max(least, (taken - kLinkedShare * letters) / (1 - kLinkedShare));
}

void CheckRules(const TypeStyle& style) {
  const RuleStyle& rules = style.rules;
  CheckRidge(rules.width, rules.height, style.size, "line rules");
  CheckRidge(rules.margin_width, rules.margin_height, style.size, "raised margin");
}

double TurningForce(const Profile& ridge, double press) { return press * GreatestSlope(ridge); }

RaisedLines RaisedLinesOf(const TextPage& page, const Script& script, const TypeStyle& style) {
  RaisedLines raised;
  if ((!style.rules.lines && !style.rules.margin) || page.glyphs.empty()) return raised;
  const Ink ink = InkOf(page, script, style);
  Box inside = page.text_area_P;
  Include(inside, ink.all);
  if (style.rules.lines) {
    raised.rules = RulesOf(ink, page.text_area_P, style);
    const double half = 0.5 * RuleProfile(style).width;
    for (const Line& rule : raised.rules) Include(inside, Grown(BoundsOf(Piece(rule)), half));
    CheckSheet(inside, page, "line rules");
  }
  if (style.rules.margin) {
    const double width = MarginProfile(style).width;
    const Box middle = Grown(inside, RuleGap(style) + 0.5 * width);
    CheckSheet(Grown(middle, 0.5 * width), page, "raised margin");
    raised.margin = Rounded(middle, std::min(2 * width, 0.25 * (middle.max.x - middle.min.x)));
  }
  return raised;
}

void AddRules(const TextPage& page, const Script& script, const TypeStyle& style,
              Texture& texture) {
  const RaisedLines raised = RaisedLinesOf(page, script, style);
  if (!raised.rules.empty()) {
    // rules of one length are one group, each by itself where the search finds it
    std::vector<std::pair<glm::dvec2, std::shared_ptr<const Group>>> built;
    Group rules;
    for (const Line& rule : raised.rules) {
      const glm::dvec2 to = rule.to - rule.from;
      const auto same =
          std::find_if(built.begin(), built.end(), [to](const auto& b) { return b.first == to; });
      if (same == built.end()) {
        built.emplace_back(to, Ridge({Line{{0, 0}, to}}, RuleProfile(style), false));
        rules.placements.push_back({built.back().second, rule.from});
      } else {
        rules.placements.push_back({same->second, rule.from});
      }
    }
    texture.layers.push_back({Finish(std::move(rules)), Relief::kEmbossed});
  }
  if (raised.margin.empty()) return;
  // a layer of its own: rules would else be looked for inside it
  texture.layers.push_back({Ridge(raised.margin, MarginProfile(style), true), Relief::kEmbossed});
}

}  // namespace moontrace
