// The C interface: texts and pages.
#include <optional>
#include <string>

#include "sim/library/call.h"
#include "sim/library/moontrace.h"
#include "sim/library/values.h"
#include "sim/picture/page_picture.h"
#include "sim/picture/picture_file.h"
#include "textures/relief/glyph_group.h"
#include "textures/relief/groove_links.h"
#include "textures/typeset/layout.h"
#include "textures/typeset/taught.h"

using namespace moontrace;

namespace {

/// One of the words that `read` knows; what is usual for none. Throws UsageError.
template <class Read>
auto WordOf(const char* given, const char* name, const char* words, Read read) {
  using Value = typename decltype(read(""))::value_type;
  if (given == nullptr) return Value{};
  const auto value = read(given);
  if (!value) throw UsageError(std::string(name) + " is one of " + words);
  return *value;
}

double OrUsual(double given, double usual) { return given > 0 ? given : usual; }

void CheckNumbers(const moontrace_style& given) {
  RequireNumber(given.margin, "style.margin", 0);
  RequireNumber(given.letter_size, "style.letter_size", 0);
  RequireNumber(given.width, "style.width", 0);
  RequireNumber(given.depth, "style.depth", 0);
  RequireNumber(given.rounding, "style.rounding", 0);
  RequireNumber(given.letter_gap, "style.letter_gap");
  RequireNumber(given.word_gap, "style.word_gap");
  RequireNumber(given.line_pitch, "style.line_pitch", 0);
  RequireNumber(given.grade, "style.grade", 0);
  if (given.reserved != 0) throw UsageError("style.reserved is not 0");
}

/// A width alone takes depth and rounding with it in proportion, as at the command line.
TypeStyle StyleOf(const moontrace_style& given, Script& script) {
  CheckNumbers(given);
  const Relief relief =
      RequireFlag(given.embossed, "style.embossed") ? Relief::kEmbossed : Relief::kEngraved;
  TypeStyle style = DefaultStyle(OrUsual(given.letter_size, script.size), relief, script);
  const double width = OrUsual(given.width, style.width);
  const double scale = width / style.width;
  style.width = width;
  style.depth = OrUsual(given.depth, scale * style.depth);
  style.rounding = OrUsual(given.rounding, scale * style.rounding);
  style.blend_radius *= scale;
  style.letter_gap += given.letter_gap;
  style.word_gap += given.word_gap;
  style.line_pitch = OrUsual(given.line_pitch, style.line_pitch);
  style.grade = OrUsual(given.grade, style.grade);
  if (given.h_form != nullptr) style.h_form = given.h_form;
  if (given.table != nullptr) style.table = given.table;
  if (given.only != nullptr) style.only = TaughtSigns(given.only, script);
  style.lines = WordOf(given.lines, "style.lines", kLineDirections, LineDirectionOf);
  style.links.reach = WordOf(given.links, "style.links", kLinkReaches, LinkReachOf);
  if (given.hyphenation != nullptr) style.hyphenation = given.hyphenation;
  style.rules.lines = RequireFlag(given.rules, "style.rules");
  style.rules.makes_room = style.rules.lines && given.line_pitch == 0;
  style.rules.margin = RequireFlag(given.raised_margin, "style.raised_margin");
  style.structure.read = RequireFlag(given.structure, "style.structure");
  if (style.lines == LineDirection::kAlternate) {
    if (!style.hyphenation.empty()) throw UsageError("alternate lines break words without hyphens");
    AddGuides(script, style);
  }
  return style;
}

std::shared_ptr<const TextValue> SetOn(const Script& script, const char* text,
                                       const moontrace_style& given) {
  auto value = std::make_shared<TextValue>();
  value->source = text;
  auto own = std::make_shared<Script>(script);
  const TypeStyle style = StyleOf(given, *own);
  PageSpec sheet = FindPage(given.sheet != nullptr ? given.sheet : "a4");
  sheet.margin = OrUsual(given.margin, sheet.margin);
  value->script = own;
  value->set = SetText(value->source, *own, style, sheet);
  return value;
}

}  // namespace

int moontrace_text_open(const moontrace_script* script, const char* text,
                        const moontrace_style* style, moontrace_text** set) {
  return Answer([&] {
    RequireNotNull(text, "text");
    RequireNotNull(set, "set");
    const InUse<ScriptTable> value(script, kScript);
    const moontrace_style given =
        style != nullptr ? Given(style, sizeof(moontrace_style), "style") : moontrace_style{};
    OpenHandle<TextTable>(
        std::make_unique<std::shared_ptr<const TextValue>>(SetOn(*value->script, text, given)),
        set);
  });
}

int moontrace_text_describe(const moontrace_text* set, moontrace_text_facts* facts) {
  return Answer([&] {
    const InUse<TextTable> value(set, kText);
    const Typeset& known = (*value)->set;
    moontrace_text_facts given{};
    given.pages = known.pages.size();
    for (const TextPage& page : known.pages) given.letters += page.glyphs.size();
    given.folded = known.folded_count;
    given.missing = known.missing_count;
    given.letter_size = known.style.size;
    given.width = known.style.width;
    given.depth = known.style.depth;
    given.line_pitch = known.style.line_pitch;
    Give(given, sizeof given, "facts", facts);
  });
}

int moontrace_text_close(moontrace_text* set) {
  return Answer([&] { CloseHandle<TextTable>(set, kText); });
}

int moontrace_page_open(const moontrace_text* set, size_t number, moontrace_page** page) {
  return Answer([&] {
    RequireNotNull(page, "page");
    const InUse<TextTable> value(set, kText);
    const Typeset& known = (*value)->set;
    if (number >= known.pages.size()) {
      throw UsageError("no page " + std::to_string(number) + ", the text has " +
                       std::to_string(known.pages.size()));
    }
    auto made = std::make_unique<PageValue>();
    made->text = *value;
    made->number = number;
    made->sheet = known.pages[number];
    const Script& script = *made->text->script;
    PageLinker(script, known.style).Keep(made->sheet);
    const Texture texture = BuildTexture(made->sheet, script, known.style);
    made->field = std::make_shared<const TextureField>(texture);
    for (const Layer& layer : texture.layers) Include(made->text_P, layer.group->bounds);
    OpenHandle<PageTable>(std::move(made), page);
  });
}

int moontrace_page_describe(const moontrace_page* page, moontrace_page_facts* facts) {
  return Answer([&] {
    const InUse<PageTable> value(page, kPage);
    moontrace_page_facts given{};
    given.width = value->text->set.page.width;
    given.height = value->text->set.page.height;
    given.letters = value->sheet.glyphs.size();
    given.lines = value->sheet.lines;
    given.greatest_fall = value->field->greatest_fall();
    given.greatest_rise = value->field->greatest_rise();
    given.greatest_slope = value->field->greatest_slope();
    Give(given, sizeof given, "facts", facts);
  });
}

int moontrace_page_letter(const moontrace_page* page, size_t number, moontrace_letter* letter) {
  return Answer([&] {
    const InUse<PageTable> value(page, kPage);
    const std::vector<PlacedGlyph>& glyphs = value->sheet.glyphs;
    if (number >= glyphs.size()) {
      throw UsageError("no letter " + std::to_string(number) + ", the page has " +
                       std::to_string(glyphs.size()));
    }
    const PlacedGlyph& placed = glyphs[number];
    moontrace_letter given{};
    given.sign = value->text->script->glyphs[placed.glyph].name.c_str();
    given.x = placed.origin_P.x;
    given.y = placed.origin_P.y;
    given.line = placed.line;
    given.word = placed.word;
    given.source_begin = placed.source_begin;
    given.source_end = placed.source_end;
    Give(given, sizeof given, "letter", letter);
  });
}

int moontrace_page_draw(const moontrace_page* page, const char* path, uint32_t flags) {
  return Answer([&] {
    RequireNotNull(path, "path");
    const InUse<PageTable> value(page, kPage);
    if ((flags & ~MOONTRACE_PRINT) != 0) throw UsageError("flags that this version does not know");
    CheckPicturePath(path);
    const TextValue& text = *value->text;
    WritePicture(path, PagePicture(value->sheet, {value->number, text.set.pages.size()}, text.set,
                                   *text.script, text.source, (flags & MOONTRACE_PRINT) != 0));
  });
}

int moontrace_page_close(moontrace_page* page) {
  return Answer([&] { CloseHandle<PageTable>(page, kPage); });
}
