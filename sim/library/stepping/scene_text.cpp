#include "sim/library/stepping/scene_text.h"

#include <string>

#include "sim/library/call.h"
#include "textures/typeset/typeset.h"

namespace moontrace {

namespace {

void SetLength(double given, const char* name, std::optional<double>& value) {
  RequireNumber(given, name, 0);
  if (given > 0) value = given;
}

void SetWord(const char* given, std::optional<std::string>& value) {
  if (given != nullptr) value = given;
}

void SetLetters(const moontrace_style& given, StyleOptions& letters) {
  if (RequireFlag(given.embossed, "style.embossed")) letters.embossed = true;
  SetLength(given.letter_size, "style.letter_size", letters.size);
  SetLength(given.width, "style.width", letters.width);
  SetLength(given.depth, "style.depth", letters.depth);
  SetLength(given.rounding, "style.rounding", letters.rounding);
  SetLength(given.grade, "style.grade", letters.grade);
  SetWord(given.h_form, letters.h_form);
  SetWord(given.table, letters.table);
  SetWord(given.only, letters.only);
  letters.structure = RequireFlag(given.structure, "style.structure");
  if (given.links == nullptr) return;
  letters.links.reach = LinkReachOf(given.links);
  if (!letters.links.reach) {
    throw UsageError(std::string("style.links is one of ") + kLinkReaches);
  }
}

void SetLayout(const moontrace_style& given, LayoutOptions& layout) {
  if (given.sheet != nullptr) {
    layout.page = FindPage(given.sheet);
    layout.page_named = true;
  }
  SetLength(given.margin, "style.margin", layout.margin);
  SetLength(given.line_pitch, "style.line_pitch", layout.line_pitch);
  RequireNumber(given.letter_gap, "style.letter_gap");
  RequireNumber(given.word_gap, "style.word_gap");
  if (given.letter_gap != 0) layout.letter_gap = given.letter_gap;
  if (given.word_gap != 0) layout.word_gap = given.word_gap;
  if (given.hyphenation != nullptr) layout.hyphenation = given.hyphenation;
  layout.sheet.rules = RequireFlag(given.rules, "style.rules");
  layout.sheet.raised_margin = RequireFlag(given.raised_margin, "style.raised_margin");
  if (given.lines == nullptr) return;
  const auto lines = LineDirectionOf(given.lines);
  if (!lines) throw UsageError(std::string("style.lines is one of ") + kLineDirections);
  layout.lines = *lines;
}

}  // namespace

void SetStyle(const moontrace_style& given, TextRequest& request) {
  if (given.reserved != 0) throw UsageError("style.reserved is not 0");
  SetLetters(given, request.style);
  SetLayout(given, request.layout);
}

}  // namespace moontrace
