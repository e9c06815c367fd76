#include "textures/typeset/typeset.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <iterator>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "textures/base/error.h"
#include "textures/base/units.h"
#include "textures/base/utf8.h"
#include "textures/typeset/fold.h"
#include "textures/typeset/hyphenation.h"
#include "textures/typeset/layout.h"
#include "textures/typeset/make_writer.h"
#include "textures/typeset/older_punctuation.h"
#include "textures/typeset/rules.h"
#include "textures/typeset/sheet_texture.h"
#include "textures/typeset/writer.h"

namespace moontrace {
namespace {

constexpr std::size_t kMostSigns = std::size_t{16} << 20;
constexpr double kCustomMargin = 0.01;  // [m]
constexpr double kLargestPage = 5;      // [m]; commands take less, a geom may be as large

bool ReadNumber(std::string_view text, double& value) {
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  return read.ec == std::errc() && read.ptr == text.data() + text.size();
}

// Written so that a NaN fails.
void CheckSides(const PageSpec& page) {
  if (!(std::min(page.width, page.height) > 0 &&
        std::max(page.width, page.height) <= kLargestPage)) {
    throw InputError(fmt::format("page {:.6g} x {:.6g} mm: give sides above 0, at most {:.0f} mm",
                                 InMillimetres(page.width), InMillimetres(page.height),
                                 InMillimetres(kLargestPage)));
  }
}

void CheckPage(const PageSpec& page) {
  CheckSides(page);
  if (!(page.margin >= 0 && std::min(page.width, page.height) > 2 * page.margin)) {
    throw InputError(fmt::format(
        "page {:.6g} x {:.6g} mm, margins {:.6g} mm: give sides above twice that, or "
        "smaller margins",
        InMillimetres(page.width), InMillimetres(page.height), InMillimetres(page.margin)));
  }
}

// Marks the signs of links and counts what a line is.
void TakeStructure(const LineMarks& marks, bool begins_line, LineKind before,
                   std::vector<Sign>& signs, StructureCounts& counts) {
  for (Sign& sign : signs) {
    const auto behind =
        std::upper_bound(marks.links.begin(), marks.links.end(), sign.begin,
                         [](std::uint32_t at, const ByteRange& link) { return at < link.begin; });
    sign.link = behind != marks.links.begin() && sign.begin < std::prev(behind)->end;
  }
  counts.links += marks.links.size();
  if (marks.kind == LineKind::kHeading && begins_line) ++counts.headings;
  if (marks.kind == LineKind::kQuotation && before != marks.kind) ++counts.quotations;
}

/// Signs of words that stand on pages without being of the text; `notes` takes what was folded in
/// them. Throws InputError for what the script cannot write.
std::vector<Sign> SignsOf(const std::string& words, const char* what, const Script& script,
                          const Writer& writer, Typeset& notes) {
  if (std::any_of(words.begin(), words.end(), [](char c) { return c >= 0 && c < ' '; })) {
    throw InputError(fmt::format("{}: give one line without tabs", what));
  }
  Folder folder(words, script, [&writer](char32_t c) { return writer.Has(c); });
  std::vector<FoldedChar> line;
  std::vector<Sign> signs;
  if (folder.NextLine(line)) writer.Write(words, 0, line, signs, notes);
  if (notes.untaught_count > 0) {
    throw InputError(fmt::format(
        "{}: '{}' is not among the signs taught (--only): add what it needs, or leave the {} out{}",
        what, notes.untaught.front().was, what,
        script.digits.empty() ? "" : "; a digit needs numeral and its letter"));
  }
  if (notes.missing_count > 0 ||
      std::all_of(signs.begin(), signs.end(), [](const Sign& sign) { return sign.space; })) {
    throw InputError(
        fmt::format("{}: script {} has no sign for '{}'", what, script.name,
                    notes.missing_count > 0 ? notes.missing.front().was : Shown(words)));
  }
  for (Sign& sign : signs) sign.begin = sign.end = 0;
  return signs;
}

[[noreturn]] void ThrowNothingToSet(const Script& script, const Typeset& result) {
  if (result.untaught_count > 0) {
    const Replacement& first = result.untaught.front();
    throw InputError(
        fmt::format("nothing left to set: '{}' (line {}, column {}) and the rest are not taught",
                    first.was, first.line, first.column));
  }
  if (result.missing_count == 0) {
    throw InputError("the text is empty or blank: give at least one letter");
  }
  const Replacement& first = result.missing.front();
  throw NoSignError(
      fmt::format("nothing left to set: script {} has no sign for '{}' (line {}, column {})",
                  script.name, first.was, first.line, first.column));
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
  CheckSides(page);
  return page;
}

Typeset SetText(std::string_view text, const Script& script, const TypeStyle& style,
                const PageSpec& page) {
  std::vector<TextPage> pages;
  Typeset result = SetPages(text, script, style, page,
                            [&pages](TextPage&& one) { pages.push_back(std::move(one)); });
  result.pages = std::move(pages);
  return result;
}

namespace {

/// The style with the line pitch that the rules of this text need. The text is set once for that,
/// since only then it is known which signs it has.
TypeStyle WithRoomForRules(std::string_view text, const Script& script, TypeStyle style,
                           const PageSpec& page) {
  style.rules.makes_room = style.rules.lines = false;
  std::set<std::size_t> used;
  SetPages(text, script, style, page, [&used](TextPage&& one) {
    for (const PlacedGlyph& glyph : one.glyphs) used.insert(glyph.glyph);
  });
  style.rules.lines = true;
  style.line_pitch = std::max(style.line_pitch, LeastRuledPitch(used, script, style));
  return style;
}

}  // namespace

Typeset SetPages(std::string_view text, const Script& script, const TypeStyle& style,
                 const PageSpec& page, const TakePage& take) {
  if (style.rules.lines && style.rules.makes_room) {
    return SetPages(text, script, WithRoomForRules(text, script, style, page), page, take);
  }
  CheckStyle(style, script);
  CheckPage(page);
  const Box sheet_P{{0, 0}, {page.width, page.height}};
  CheckRules(style);
  CheckSheetTexture(style, sheet_P);
  const std::unique_ptr<Writer> writer = MakeWriter(script, style);
  Folder folder(text, script, [&writer](char32_t c) { return writer->Has(c); });
  bool any = false;
  Layout layout(script, style, page, [&](TextPage&& one) {
    any = true;
    take(std::move(one));
  });

  const auto words = [&](const std::string& what, const char* option) {
    Typeset notes;
    return SignsOf(what, option, script, *writer, notes);
  };
  Typeset result;
  std::optional<Hyphenation> hyphenation;
  if (!style.hyphenation.empty()) {
    hyphenation.emplace(style.hyphenation);
    layout.SetHyphen(words("-", "hyphenation").front());
  }
  if (!style.running_head.empty() || style.page_numbers) {
    Layout::NumberSigns number;
    if (style.page_numbers) {
      number = [words](std::size_t n) { return words(std::to_string(n), "page numbers"); };
    }
    layout.SetHead(style.running_head.empty()
                       ? std::vector<Sign>()
                       : SignsOf(style.running_head, "running head", script, *writer, result),
                   number);
  }

  result.style = style;
  result.page = page;
  std::vector<FoldedChar> line;
  std::vector<Sign> signs;
  std::size_t count = 0;
  LineKind before = LineKind::kPlain;
  while (folder.NextLine(line)) {
    signs.clear();
    LineMarks marks;
    if (style.structure.read) marks = TakeMarks(text, line, folder.begins_line());
    if (!folder.begins_line()) marks.kind = before;
    if (style.older_punctuation) UseOlderPunctuation(text, script, line);
    writer->Write(text, folder.line_number(), line, signs, result);
    TakeStructure(marks, folder.begins_line(), before, signs, result.structure);
    if (hyphenation) hyphenation->Mark(text, signs);
    before = marks.kind;
    count += signs.size();
    if (count > kMostSigns) {
      throw InputError(
          fmt::format("the text makes more than {} million signs: split it", kMostSigns >> 20));
    }
    layout.AddLine(signs, marks.kind, folder.begins_line());
  }
  layout.Finish();
  if (!any) ThrowNothingToSet(script, result);
  return result;
}

}  // namespace moontrace
